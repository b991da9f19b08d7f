// SPDX-License-Identifier: Apache-2.0
// Lambert, Photometria, 1760.
#include "core/lobe.cl"

static inline void lambert_eval(const lambert_params* p, const directions* d, real f[CHANNELS])
{
    FOR_CHANNELS(c) f[c] = (real)(p->rho[c] / PI);
}

static inline real lambert_pdf(const lambert_params* p, const directions* d)
{
    return d->cos_o * (R(1.0) / PI);
}

static inline mirror_offset lambert_sample(const lambert_params* p, const fixed_light* l,
                                           stream* random)
{
    return about_normal(l, random);
}

// SPDX-License-Identifier: Apache-2.0
// Minnaert, Astrophysical Journal 93, 1941: rho (k + 1)/(2 pi) ((n.l)(n.v))^(k - 1).
#include "core/lobe.cl"

static inline void minnaert_eval(const minnaert_params* p, const directions* d, real f[CHANNELS])
{
    const float norm = (p->k + R(1.0)) * (R(0.5) / PI);
    const real lobe =
        norm * power_of_parts(parts_of_positive(d->cos_i * d->cos_o), (real)(p->k - R(1.0)));
    FOR_CHANNELS(c) f[c] = p->rho[c] * lobe;
}

// SPDX-License-Identifier: Apache-2.0
// Burley, SIGGRAPH course notes, 2012, 5.3: rho/pi (1 + (F - 1)(1 - n.l)^5)(1 + (F - 1)(1 - n.v)^5)
// with F = 1/2 + 2 roughness cos^2 theta_d.
#include "core/lobe.cl"

static inline void burley_eval(const burley_params* p, const directions* d, real f[CHANNELS])
{
    const real rise = R(2.0) * p->roughness * d->cos2_d - R(0.5);
    const real lobe = (R(1.0) / PI) * ((R(1.0) + rise * fifth_power(R(1.0) - d->cos_i)) *
                                       (R(1.0) + rise * fifth_power(R(1.0) - d->cos_o)));
    FOR_CHANNELS(c) f[c] = p->rho[c] * lobe;
}

// SPDX-License-Identifier: Apache-2.0
// Ward, SIGGRAPH 1992, eq. 5a, without its diffuse term.
#include "core/lobe.cl"

static inline void ward_eval(const ward_params* p, const directions* d, real f[CHANNELS])
{
    const real q = stretched_slope2(d, p->alpha_x, p->alpha_y);
    const real norm = R(1.0) / (R(4.0) * PI * p->alpha_x * p->alpha_y * sqrt(d->cos_i * d->cos_o));
    const real lobe = exp_of_negative(q) * norm;
    FOR_CHANNELS(c) f[c] = p->rho_s[c] * lobe;
}

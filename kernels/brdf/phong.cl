// SPDX-License-Identifier: Apache-2.0
// Phong, CACM 18(6), 1975, normalised by Lafortune & Willems, Report CW 197, KU Leuven, 1994: rho_s
// (n + 2)/(2 pi) (r.v)^n.
#include "core/lobe.cl"

/// log(r.v) where r.v > 0, from whichever form is exact there.
/// log(r.v) where r.v > 0, from whichever form is exact there.
static inline real log_of_cos_r(const directions* d)
{
    const mask_t near_mirror = less(d->mirror, (real)(R(0.5)));
    return log_of_sum(choose(near_mirror, (real)(R(1.0)), (real)(R(0.0))),
                      choose(near_mirror, -d->mirror, d->cos_r));
}

static inline void phong_eval(const phong_params* p, const directions* d, real f[CHANNELS])
{
    const float norm = (p->exponent + R(2.0)) / (R(2.0) * PI);
    const real power = exp_of_negative(-p->exponent * log_of_cos_r(d));
    const real lobe = choose(less((real)(R(0.0)), d->cos_r), norm * power, (real)(R(0.0)));
    FOR_CHANNELS(c) f[c] = p->rho_s[c] * lobe;
}

// SPDX-License-Identifier: Apache-2.0
// Schlick, Graphics Gems IV, 1994: the value t/(n - n t + t) in place of the power t^n.
#include "core/lobe.cl"

/// t = r.v: n - n t + t = n (1 - t) + t, both exact where they are small.
static inline real schlick_of_cos_r(const directions* d, float n)
{
    const real rational = d->cos_r / (n * d->mirror + d->cos_r);
    return choose(less((real)(R(0.0)), d->cos_r), rational, (real)(R(0.0)));
}

/// t = n.h = 1/s: 1/(1 + n (s - 1)) with s - 1 = tan^2/(s + 1).
static inline real schlick_of_cos_h(const directions* d, float n)
{
    const real sum = R(1.0) + sqrt(d->sec2_h);
    return sum / (n * d->tan2_h + sum);
}

static inline void schlick_eval(const schlick_params* p, const directions* d, real f[CHANNELS])
{
    const real lobe = p->argument == schlick_argument_r_dot_v ? schlick_of_cos_r(d, p->exponent)
                                                              : schlick_of_cos_h(d, p->exponent);
    FOR_CHANNELS(c) f[c] = p->k_s[c] * lobe;
}

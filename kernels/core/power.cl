// SPDX-License-Identifier: Apache-2.0
// Powers of the cosines that highlights are made of, exact for exponents of a million.
#ifndef GONIO_CORE_POWER
#define GONIO_CORE_POWER
#include "core/math.cl"
#include "directions/directions.cl"

/// (r.v)^n for n >= 0; 0 where r.v <= 0.
static inline real power_of_cos_r(const directions* d, float n)
{
    const real power = exp_of_negative(-n * log_of_cosine(d->cos_r, d->mirror));
    return choose(less((real)(R(0.0)), d->cos_r), power, (real)(R(0.0)));
}

/// (n.h)^n for n >= 0, from (n.h)^2 = 1/(1 + tan^2).
static inline real power_of_cos_h(const directions* d, float n)
{
    return exp_of_negative(R(0.5) * n * log_of_one_plus(d->tan2_h));
}

/// 1 - cos of the angle whose cosine to the power of n > 0 is u, in (0, 1).
static inline real one_less_root(real u, real n)
{
    return one_less_exp_of_negative(-log_of_positive(u) / n);
}

/// tan^2 of the angle whose cosine to the power of n > 1/4 is u, in [2^-24, 1).
static inline real tan2_of_root(real u, real n)
{
    const real q = R(-2.0) * log_of_positive(u) / n;
    return one_less_exp_of_negative(q) / exp_of_negative(q);
}

#endif

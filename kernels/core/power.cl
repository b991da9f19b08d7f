// SPDX-License-Identifier: Apache-2.0
// Powers of the cosines that highlights are made of, exact for exponents of a million.
#ifndef GONIO_CORE_POWER
#define GONIO_CORE_POWER
#include "core/math.cl"
#include "directions/directions.cl"

/// 2^y for y <= 126, and 0 below -126, of what highlights need: error below 2.5 ulp, in a chain
/// shorter than that of exp_of_negative().
static inline real two_to(real y)
{
    const real shifted = y + ROUNDING_SHIFT;
    const real r = y - (shifted - ROUNDING_SHIFT);
    const real z = r * r;
    const real low = fma((real)(R(0.693146977599)), r, (real)(R(1.0)));
    const real middle = fma((real)(R(0.0555073374342)), r, (real)(R(0.240222420853)));
    const real high = fma((real)(R(0.00132647271463)), r, (real)(R(0.00967151264322)));
    const real fraction = fma(z, fma(z, high, middle), low);
    const real result = as_real(bits_of(fraction) + (bits_of(shifted) << 23));
    return choose(less((real)(R(-126.0)), y), result, (real)(R(0.0)));
}

/// x^p, to 45 ulp where it is at least 1e-6. log2(1 + f) = f P(f) is good to 2e-7 relative and no
/// better: every term and operation less of the chain that limits highlights is time.
static inline real power_of_parts(float_parts x, real p)
{
    const real f = x.f, z = f * f;
    const real c0 = fma((real)(R(-0.721352788065)), f, (real)(R(1.44269496199)));
    const real c2 = fma((real)(R(-0.36023963954)), f, (real)(R(0.480923242244)));
    const real c4 = fma((real)(R(-0.248876868958)), f, (real)(R(0.287098701315)));
    const real c6 = fma((real)(R(-0.14581165835)), f, (real)(R(0.234042357584)));
    const real series = fma(z * z, fma(c6, z, c4), fma(c2, z, c0));
    return two_to(fma(f * p, series, real_of(x.n_in_place) * (p * R(1.1920928955078125e-7))));
}

/// (r.v)^n for n >= 0; 0 where r.v <= 0.
static inline real power_of_cos_r(const directions* d, float n)
{
    const real power = power_of_parts(parts_of_cosine(d->cos_r, d->mirror), (real)(n));
    return choose(less((real)(R(0.0)), d->cos_r), power, (real)(R(0.0)));
}

/// (n.h)^n for n >= 0, from (n.h)^2 = 1/(1 + tan^2).
static inline real power_of_cos_h(const directions* d, real n)
{
    return power_of_parts(parts_of_sum((real)(R(1.0)), d->tan2_h), R(-0.5) * n);
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

// SPDX-License-Identifier: Apache-2.0
// Elementary functions: OpenCL's own differ between vector widths and devices. Errors stated here are measured by
// tests/kernels/math_test.cpp against double.
#ifndef GONIO_CORE_MATH
#define GONIO_CORE_MATH
#include "core/real.cl"

#define LOG2_E R(1.44269504088896341)
#define LN2_HI R(0.693145751953125)
#define LN2_LO R(1.42860682030941723e-6)

/// 2^n for -126 <= n <= 127.
static inline real power_of_two(mask_t n) { return as_real((n + 127) << 23); }

/// exp(-q) for q >= 0; 0 beyond q = 104. Error below 1.1 ulp down to the smallest normal number.
static inline real exp_of_negative(real q)
{
    const real x = -min(q, (real)(R(150.0)));
    const real n = floor(x * LOG2_E + R(0.5));
    const real r = fma(n, (real)(-LN2_LO), fma(n, (real)(-LN2_HI), x));
    real p = (real)(R(0.00139261761199));
    p = fma(p, r, (real)(R(0.00836317307451)));
    p = fma(p, r, (real)(R(0.0416665546621)));
    p = fma(p, r, (real)(R(0.166665770256)));
    p = fma(p, r, (real)(R(0.5)));
    const real result = fma(r * r, p, r) + R(1.0);
    // In two steps, so that results below 2^-126 are rounded once and not flushed.
    const mask_t whole = to_int(n);
    const mask_t half_of_it = whole >> 1;
    return result * power_of_two(half_of_it) * power_of_two(whole - half_of_it);
}

/// log(x) for normal x > 0. Error below 1 ulp.
static inline real log_of_positive(real x)
{
    // x = 2^n m with m in [sqrt 1/2, sqrt 2): the offset makes the exponent field round at sqrt 2.
    const bits_t bits = as_bits(x) + (bits_t)(0x3f800000u - 0x3f3504f3u);
    const real n = to_real(to_int(bits >> 23) - 127);
    const real m = as_real((bits & 0x007fffffu) + 0x3f3504f3u);
    // log m = 2 artanh s = 2 s + s z P(z), with 2 s written as f - s f so that the leading term is exact.
    const real f = m - R(1.0);
    const real s = f / (R(2.0) + f);
    const real z = s * s;
    real p = (real)(R(0.29579949392));
    p = fma(p, z, (real)(R(0.39988780566)));
    p = fma(p, z, (real)(R(0.666666850396)));
    const real tail = fma(s, z * p - f, n * LN2_LO);
    return fma(n, (real)(LN2_HI), f + tail);
}

/// log(x.hi + x.lo) for x.hi > 0: keeps the relative accuracy of a sum such as 1 + small.
static inline real log_of_two_floats(two_floats x) { return log_of_positive(x.hi) + x.lo / x.hi; }

/// log(1 + x) for x > -1. Error below 2 ulp.
static inline real log_of_one_plus(real x) { return log_of_two_floats(two_sum((real)(R(1.0)), x)); }

/// exp(x^2) erfc(x) for x >= 0, as a polynomial in (x - 2)/(x + 2) over 1 + 2 x. Error below 4 ulp.
static inline real scaled_erfc(real x)
{
    const real t = R(1.0) - R(4.0) / (x + R(2.0));
    real p = (real)(R(6.8066793745e-5));
    p = fma(p, t, (real)(R(0.000160832628389)));
    p = fma(p, t, (real)(R(-0.000370910480331)));
    p = fma(p, t, (real)(R(-0.00139578852219)));
    p = fma(p, t, (real)(R(0.00123049032813)));
    p = fma(p, t, (real)(R(0.00868924078714)));
    p = fma(p, t, (real)(R(-0.00802473548486)));
    p = fma(p, t, (real)(R(-0.0542119918942)));
    p = fma(p, t, (real)(R(0.164050496785)));
    p = fma(p, t, (real)(R(-0.166031090728)));
    p = fma(p, t, (real)(R(-0.0927638157399)));
    p = fma(p, t, (real)(R(1.2769783912)));
    return p / (R(1.0) + R(2.0) * x);
}

#endif

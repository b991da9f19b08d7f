// SPDX-License-Identifier: Apache-2.0
// Elementary functions: OpenCL's own differ between vector widths and devices. Errors stated here
// are measured by tests/kernels/math_test.cpp, against double.
#ifndef GONIO_CORE_MATH
#define GONIO_CORE_MATH
#include "core/real.cl"

/// Adding it rounds a number below 2^22 to an integer, which then stands in the low bits.
#define ROUNDING_SHIFT R(12582912.0)

/// exp(r) - 1 for |r| <= 0.35
static inline real exp_less_one(real r)
{
    // In pairs: one evaluation is a chain of operations, and its length is what costs time.
    const real z = r * r;
    const real high = fma((real)(R(0.00139261761199)), r, (real)(R(0.00836317307451)));
    const real even = fma((real)(R(0.0416665546621)), z, (real)(R(0.5)));
    const real odd = fma(high, z, (real)(R(0.166665770256)));
    return fma(z, fma(odd, r, even), r);
}

/// exp(-q) for q >= -87, and 0 from q = 87 on, before float32 runs out of normal numbers. Error
/// below 1.4 ulp for |q| <= 16, 5 ulp beyond.
static inline real exp_of_negative(real q)
{
    const real shifted = fma(q, (real)(R(-1.44269504088896341)), (real)(ROUNDING_SHIFT));
    const real n = shifted - ROUNDING_SHIFT;
    const real r = fma(n, (real)(R(-0.693147180559945309)), -q);
    const real fraction = exp_less_one(r) + R(1.0);
    const real result = as_real(bits_of(fraction) + (bits_of(shifted) << 23));
    return choose(less(q, (real)(R(87.0))), result, (real)(R(0.0)));
}

/// 1 - exp(-q) for 0 <= q <= 87, relatively accurate also where q is small. Error below 1.5
/// ulp.
static inline real one_less_exp_of_negative(real q)
{
    const real n = fma(q, (real)(R(-1.44269504088896341)), (real)(ROUNDING_SHIFT)) - ROUNDING_SHIFT;
    const real r = fma(n, (real)(R(-0.693147180559945309)), -q);
    return choose(less(n, (real)(R(-0.5))), R(1.0) - exp_of_negative(q), -exp_less_one(r));
}

/// sinh(x) for 0 <= x <= 87. Error below 2 ulp up to 16.
static inline real hyperbolic_sine(real x)
{
    const real z = x * x;
    real p = (real)(R(2.7557319e-6));
    p = fma(p, z, (real)(R(1.98412698e-4)));
    p = fma(p, z, (real)(R(8.33333333e-3)));
    p = fma(p, z, (real)(R(0.166666667)));
    const real grown = exp_of_negative(-x);
    const real far = R(0.5) * grown - R(0.5) / grown;
    return choose(less(x, (real)(R(1.0))), fma(x * z, p, x), far);
}

/// A positive number as 2^n (1 + f), 1 + f in [sqrt 1/2, sqrt 2).
typedef struct {
    mask_t n_in_place;  ///< n times 2^23
    real f;
} float_parts;

/// n times 2^23 of x: the offset makes the exponent field round at sqrt 2.
static inline mask_t binary_exponent(real x)
{
    return (bits_of(x) - 0x3f3504f3) & (mask_t)(0xff800000);
}

/// base + x, normal and in (0, 1e38], where base is 0 or 1 or both are a sum in two floats: f is
/// relatively accurate also where the sum is near 1.
static inline float_parts parts_of_sum(real base, real x)
{
    const mask_t n = binary_exponent(base + x);
    const real scale = as_real(0x3f800000 - n);
    // f is made from x itself, so that what the sum rounds away is not lost.
    const float_parts parts = {n, fma(x, scale, fma(base, scale, (real)(R(-1.0))))};
    return parts;
}

/// Normal x in (0, 1e38].
static inline float_parts parts_of_positive(real x)
{
    const mask_t n = binary_exponent(x);
    const float_parts parts = {n, fma(x, as_real(0x3f800000 - n), (real)(R(-1.0)))};
    return parts;
}

/// Normal x in (0, 1], of which both x and 1 - x are known: f is relatively accurate near 1.
static inline float_parts parts_of_cosine(real x, real one_minus_x)
{
    float_parts parts = parts_of_positive(x);
    // Up to 1/4, n is 0.
    parts.f = choose(less(one_minus_x, (real)(R(0.25))), -one_minus_x, parts.f);
    return parts;
}

/// log(1 + f) + n ln 2. Error below 2 ulp.
static inline real log_of_parts(float_parts x)
{
    // log(1 + f) = f + f^2 (f P(f) - 1/2), P in pairs: shorter than the chain through a division.
    const real f = x.f, z = f * f;
    const real low = fma((real)(R(-0.2500081956386566)), f, (real)(R(0.3333333134651184)));
    const real middle = fma((real)(R(-0.16623356938362122)), f, (real)(R(0.20001226663589478)));
    const real high = fma((real)(R(-0.13160184025764465)), f, (real)(R(0.14201758801937103)));
    const real top = fma((real)(R(-0.07634488493204117)), f, (real)(R(0.12761573493480682)));
    const real p = fma(fma(fma(top, z, high), z, middle), z, low);
    const real log_of_fraction = fma(z, fma(f, p, (real)(R(-0.5))), f);
    return fma(real_of(x.n_in_place), (real)(R(8.26295829e-8)), log_of_fraction);
}

/// log(x) for normal x in (0, 1e38].
static inline real log_of_positive(real x)
{
    return log_of_parts(parts_of_positive(x));
}

/// log(1 + x) for x > -1.
static inline real log_of_one_plus(real x)
{
    return log_of_parts(parts_of_sum((real)(R(1.0)), x));
}

/// exp(x^2) erfc(x) for x >= 0, as a polynomial in (x - 2)/(x + 2) over 1 + 2 x. Error below 5 ulp.
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

/// The x with erfc(-x) = s for 2^-24 <= s <= 2 - 2^-23, in two pieces as Giles, Approximating the
/// erfinv function, GPU Computing Gems 2, 2012, has them. Error below 9 ulp.
static inline real inverse_of_erfc(real s)
{
    const real w = -log_of_positive(s * (R(2.0) - s));
    const real t = w - R(2.5);
    real p = (real)(R(2.26059777e-8));
    p = fma(p, t, (real)(R(3.42224709e-7)));
    p = fma(p, t, (real)(R(-3.45477951e-6)));
    p = fma(p, t, (real)(R(-4.38034671e-6)));
    p = fma(p, t, (real)(R(0.00021831298)));
    p = fma(p, t, (real)(R(-0.00125375888)));
    p = fma(p, t, (real)(R(-0.00417734652)));
    p = fma(p, t, (real)(R(0.246640766)));
    p = fma(p, t, (real)(R(1.50140935)));
    const real far = sqrt(max(w, (real)(R(5.0)))) - R(3.0);
    real tail = (real)(R(-0.000177329141));
    tail = fma(tail, far, (real)(R(0.00119429995)));
    tail = fma(tail, far, (real)(R(-0.00337861887)));
    tail = fma(tail, far, (real)(R(0.00575769338)));
    tail = fma(tail, far, (real)(R(-0.00771292692)));
    tail = fma(tail, far, (real)(R(0.00944290034)));
    tail = fma(tail, far, (real)(R(1.00168115)));
    tail = fma(tail, far, (real)(R(2.83297668)));
    return choose(less(w, (real)(R(5.0))), p, tail) * (s - R(1.0));
}

/// The angle in [0, pi/2] whose sine and cosine, both >= 0 and not both 0, have this ratio. Error
/// below 3 ulp.
static inline real angle_of(real sine, real cosine)
{
    // atan t for t = tan(angle - base) with base 0 or pi/4 and |t| <= tan(pi/8)
    const real lesser = min(sine, cosine), greater = max(sine, cosine);
    const mask_t near_diagonal = less(greater * R(0.41421356237), lesser);
    const real t = choose(near_diagonal, lesser - greater, lesser) /
                   choose(near_diagonal, lesser + greater, greater);
    const real z = t * t;
    real p = (real)(R(0.08060065656900406));
    p = fma(p, z, (real)(R(-0.1387978047132492)));
    p = fma(p, z, (real)(R(0.1997791975736618)));
    p = fma(p, z, (real)(R(-0.33332955837249756)));
    const real base = choose(near_diagonal, (real)(R(0.25) * PI), (real)(R(0.0)));
    const real angle = base + fma(t * z, p, t);
    return choose(less(cosine, sine), R(0.5) * PI - angle, angle);
}

#endif

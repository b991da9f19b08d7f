// SPDX-License-Identifier: Apache-2.0
// Reflectance of a smooth interface for unpolarised light, written without the cancellation of the
// textbook forms.
#ifndef GONIO_CORE_FRESNEL
#define GONIO_CORE_FRESNEL
#include "core/real.cl"

/// Schlick, CGF 13(3), 1994, eq. 15.
static inline real fresnel_schlick(float f0, real cos_d)
{
    return f0 + (R(1.0) - f0) * fifth_power(R(1.0) - cos_d);
}

/// Born & Wolf 1.5.2 with g^2 = eta^2 - sin^2 (Cook & Torrance 1982, eq. 15); g - c is written as
/// (eta^2 - 1)/(g + c). Total reflection where g^2 < 0.
static inline real fresnel_dielectric(float eta, real c)
{
    const float excess = (eta - R(1.0)) * (eta + R(1.0));
    const real g2 = excess + c * c;
    const real g = sqrt(max(g2, (real)(R(0.0))));
    const real sum = g + c;
    const real difference = excess / sum;
    const real ratio = (c * sum - R(1.0)) / (c * difference + R(1.0));
    const real f = R(0.5) * square(difference / sum) * (R(1.0) + square(ratio));
    return choose(less((real)(R(0.0)), g2), f, (real)(R(1.0)));
}

/// Born & Wolf 14.2: u + i v is the complex cosine inside times the index, u v = eta k and u^2 -
/// v^2 = eta^2 - k^2 - sin^2; the smaller one of u, v follows from the larger. Where u is the
/// larger, it may be near c: there c - u = (c^2 - u^2)/(c + u).
static inline real fresnel_conductor(float eta, float k, real c)
{
    const float excess = (eta - R(1.0)) * (eta + R(1.0)) - k * k;
    const real difference = excess + c * c;
    const real sum = sqrt(square(difference) + square(R(2.0) * eta * k));
    const real larger = sqrt(R(0.5) * (sum + fabs(difference)));
    const real smaller = eta * k / max(larger, (real)(R(1e-30)));
    const mask_t transparent = less((real)(R(0.0)), difference);
    const real u = choose(transparent, larger, smaller);
    const real v = choose(transparent, smaller, larger);
    const real c_minus_u = choose(transparent, -(excess + v * v) / (c + u), c - u);
    const real s = (square(c_minus_u) + v * v) / (square(c + u) + v * v);
    const real t3 = (excess + R(1.0)) * c;
    const real t4 = R(2.0) * eta * k * c;
    const real p =
        (square(excess * c + c_minus_u) + square(t4 - v)) / (square(t3 + u) + square(t4 + v));
    return R(0.5) * (s + p);
}

#endif

// SPDX-License-Identifier: Apache-2.0
// Reflectance of a smooth interface for unpolarised light, without the cancellation of the textbook
// forms.
#ifndef GONIO_CORE_FRESNEL
#define GONIO_CORE_FRESNEL
#include "directions/directions.cl"

/// The angle between the light and a surface's normal. A surface that is less dense inside reflects
/// all light beyond a critical angle, with infinite slope there: it needs cos^2 in two floats, and
/// takes it as a sum whose first part does not change along a row.
typedef struct {
    real cosine, sin2;
    two_floats cos2_row, cos2_rest;
} incidence;

static inline two_floats halved(two_floats a)
{
    const two_floats result = {R(0.5) * a.hi, R(0.5) * a.lo};
    return result;
}

/// On the facet whose normal is the half vector: cos^2 theta_d = (1 + l.v)/2.
static inline incidence on_facet(const directions* d)
{
    const two_floats one_half = {(real)(R(0.5)), (real)(R(0.0))};
    const incidence at = {sqrt(d->cos2_d), d->sin2_d, two_floats_plus(one_half, halved(d->cos_cos)),
                          halved(d->tangent)};
    return at;
}

/// On the surface itself, along l or v.
static inline incidence on_surface(real cosine, real cosine_lo, real sine)
{
    const two_floats both = {cosine, cosine_lo}, nothing = {(real)(R(0.0)), (real)(R(0.0))};
    const incidence at = {cosine, square(sine), two_floats_product(both, both), nothing};
    return at;
}

/// Schlick, CGF 13(3), 1994, eq. 15.
static inline real fresnel_schlick(float f0, real cosine)
{
    return f0 + (R(1.0) - f0) * fifth_power(R(1.0) - cosine);
}

/// The real part of w^2 = N - sin^2 with N = (eta + i k)^2, and of N - 1 in `excess`.
static inline real squared_inner_cosine(float eta, float k, float excess, const incidence* at)
{
    if (eta >= R(1.0)) return excess + square(at->cosine);
    const two_floats re = {(real)(eta), (real)(R(0.0))}, im = {(real)(k), (real)(R(0.0))};
    const two_floats minus_one = {(real)(R(-1.0)), (real)(R(0.0))};
    const two_floats n = two_floats_minus(two_floats_product(re, re), two_floats_product(im, im));
    const two_floats row = two_floats_plus(two_floats_plus(n, minus_one), at->cos2_row);
    return two_floats_sum(row, at->cos2_rest);
}

/// Born & Wolf 14.2: with c = cos and w = u + i v the inside's complex cosine times its index
/// N^1/2, s light has R_s = |c - w|^2/|c + w|^2 = |N - 1|^2/|c + w|^4 and p light R_p = R_s |c w -
/// sin^2|^2/ |c w + sin^2|^2. Their mean is R_s A/|c w + sin^2|^2, A = c^2 |w|^2 + sin^4: sums of
/// positive terms. Here w2 is |w|^2, cu is c u, strength |N - 1|.
static inline real unpolarised(real c, real sin2, real w2, real cu, float strength)
{
    const real both = square(c) * w2 + square(sin2);
    const real p_below = both + R(2.0) * cu * sin2;
    const real s_below = w2 + square(c) + R(2.0) * cu;
    return both * p_below * square(strength / (s_below * p_below));
}

/// Without extinction: Born & Wolf 1.5.2. Total reflection where w^2 < 0.
static inline real fresnel_dielectric(float eta, incidence at)
{
    const float excess = (eta - R(1.0)) * (eta + R(1.0));
    const real w2 = squared_inner_cosine(eta, R(0.0), excess, &at);
    const real w = sqrt(max(w2, (real)(R(0.0))));
    // The terms of unpolarised() are squares here.
    const real cw = at.cosine * w;
    const real scaled = excess / (square(at.cosine + w) * (cw + at.sin2));
    const real f = (square(cw) + square(at.sin2)) * square(scaled);
    return choose(less((real)(R(0.0)), w2), f, (real)(R(1.0)));
}

/// u v = eta k: the smaller one follows from the larger.
static inline real fresnel_conductor(float eta, float k, incidence at)
{
    const float excess = (eta - R(1.0)) * (eta + R(1.0)) - k * k;
    const float uv = eta * k;
    const float strength = sqrt(excess * excess + R(4.0) * uv * uv);
    const real re = squared_inner_cosine(eta, k, excess, &at);
    const real w2 = sqrt(square(re) + R(4.0) * uv * uv);
    const real larger = sqrt(R(0.5) * (w2 + fabs(re)));
    const real u = choose(less((real)(R(0.0)), re), larger, uv / max(larger, (real)(R(1e-30))));
    return unpolarised(at.cosine, at.sin2, w2, at.cosine * u, strength);
}

#endif

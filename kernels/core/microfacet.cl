// SPDX-License-Identifier: Apache-2.0
// Distributions of facet normals and their Smith masking, in slopes and without cancellation.
#ifndef GONIO_CORE_MICROFACET
#define GONIO_CORE_MICROFACET
#include "core/math.cl"
#include "directions/directions.cl"

/// Walter et al., EGSR 2007, eq. 33, with alpha_x, alpha_y: q is the stretched slope of h squared.
/// Bounded at grazing half vectors, where tan^2 overflows when it is squared.
static inline real ggx_distribution(const directions* d, real q, float alpha_x, float alpha_y)
{
    return (R(1.0) / (PI * alpha_x * alpha_y)) * square(d->sec2_h / (R(1.0) + q));
}

/// Beckmann & Spizzichino 1963; Walter et al. 2007, eq. 25.
static inline real beckmann_distribution(const directions* d, real q, float alpha_x, float alpha_y)
{
    return exp_of_negative(q) * (R(1.0) / (PI * alpha_x * alpha_y)) * d->sec2_h * d->sec2_h;
}

/// G2 / (4 cos_i cos_o) for GGX with height-correlated masking (Heitz, JCGT 3(2), 2014, eq. 99),
/// multiplied out so that nothing is divided by a cosine. p: alpha times the tangential part of a
/// direction, squared.
static inline real ggx_visibility(real p_i, real p_o, real cos_i, real cos_o)
{
    return R(0.5) / (cos_o * sqrt(p_i + square(cos_i)) + cos_i * sqrt(p_o + square(cos_o)));
}

/// cos Lambda(cos) of a Beckmann surface (Walter et al. 2007; Heitz 2014, eq. 66), finite at
/// grazing.
static inline real beckmann_cos_lambda(real p, real cos_w)
{
    const real projected = sqrt(p);
    // At normal incidence Lambda is 0; the bound on a keeps 0/0 away and exp(-a^2) is 0 long
    // before.
    const real a = min(cos_w / max(projected, (real)(R(1e-30))), (real)(R(12.0)));
    return R(0.5) * exp_of_negative(a * a) *
           max(projected * R(0.56418958354775629) - cos_w * scaled_erfc(a), (real)(R(0.0)));
}

/// G2 / (4 cos_i cos_o) for Beckmann with height-correlated masking.
static inline real beckmann_visibility(real p_i, real p_o, real cos_i, real cos_o)
{
    const real masked =
        cos_o * beckmann_cos_lambda(p_i, cos_i) + cos_i * beckmann_cos_lambda(p_o, cos_o);
    return R(0.25) / (cos_i * cos_o + masked);
}

/// G / (4 cos_i cos_o) of symmetric V-shaped grooves (Torrance & Sparrow 1967; Cook & Torrance
/// 1982): G = min(1, 2 cos_h cos_i / cos_d, 2 cos_h cos_o / cos_d), with cos_h cos_d = mean_cos.
static inline real v_cavity_visibility(const directions* d)
{
    const real open = R(0.25) / (d->cos_i * d->cos_o);
    const real blocked = R(0.5) * d->mean_cos / max(d->cos_i, d->cos_o);
    return min(open, blocked / d->cos2_d);
}

#endif

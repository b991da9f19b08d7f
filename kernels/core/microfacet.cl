// SPDX-License-Identifier: Apache-2.0
// Distributions of facet normals and their masking, in slopes and without cancellation.
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
static inline real ggx_correlated_visibility(real p_i, real p_o, real cos_i, real cos_o)
{
    return R(0.5) / (cos_o * sqrt(p_i + square(cos_i)) + cos_i * sqrt(p_o + square(cos_o)));
}

/// G1 / (2 cos) for GGX: Walter et al. 2007, eq. 34.
static inline real ggx_masking(real p, real cos_w)
{
    return R(1.0) / (cos_w + sqrt(p + square(cos_w)));
}

/// cos Lambda(cos) of a Beckmann surface (Walter et al. 2007; Heitz 2014, eq. 66), finite at
/// grazing.
static inline real beckmann_cos_lambda(real p, real cos_w)
{
    const real projected = sqrt(p);
    // At normal incidence Lambda is 0; the bound on a keeps 0/0 away and exp(-a^2) is 0 long
    // before.
    const real a = min(cos_w / max(projected, (real)(R(1e-30))), (real)(R(12.0)));
    const real tail = projected * R(0.56418958354775629) - cos_w * scaled_erfc(a);
    return R(0.5) * exp_of_negative(a * a) * max(tail, (real)(R(0.0)));
}

/// G2 / (4 cos_i cos_o) for Beckmann with height-correlated masking.
static inline real beckmann_correlated_visibility(real p_i, real p_o, real cos_i, real cos_o)
{
    const real masked =
        cos_o * beckmann_cos_lambda(p_i, cos_i) + cos_i * beckmann_cos_lambda(p_o, cos_o);
    return R(0.25) / (cos_i * cos_o + masked);
}

/// G1 / (2 cos) for Beckmann.
static inline real beckmann_masking(real p, real cos_w)
{
    return R(0.5) / (cos_w + beckmann_cos_lambda(p, cos_w));
}

/// sec^2 theta_h G / (4 cos_i cos_o) of symmetric V-shaped grooves (Torrance & Sparrow 1967):
/// G = min(1, 2 cos_h min(cos_i, cos_o)/cos_d). With cos_h cos_d = mean_cos that factor needs no
/// division in the loop.
static inline real v_cavity_visibility(const directions* d)
{
    const real open = R(0.25) / (d->cos_i * d->cos_o);
    const real blocked = R(0.5) / (d->mean_cos * max(d->cos_i, d->cos_o));
    return min(d->sec2_h * open, blocked);
}

/// G1(l, h) / (4 cos_i) of these grooves: Heitz & d'Eon, CGF 33(4), 2014.
static inline real v_cavity_visible_part(const directions* d)
{
    return min(R(0.25) / d->cos_i, R(0.5) / (d->mean_cos * d->sec2_h));
}

#endif

// SPDX-License-Identifier: Apache-2.0
// What a model sees of a pair of directions. Grids fill it; what a model does not read is never
// computed.
#ifndef GONIO_DIRECTIONS
#define GONIO_DIRECTIONS
#include "core/real.cl"

/// 1: materials without a tangent frame; then the stretched quantities below need only the polar
/// angles.
#ifndef ISOTROPIC
#define ISOTROPIC 0
#endif

typedef struct {
    real cos_i, cos_o;        ///< n.l, n.v
    real cos_i_lo, cos_o_lo;  ///< what their rounding took away
    real sin_i, sin_o;
    real mean_cos;        ///< (cos_i + cos_o)/2, which is cos theta_h cos theta_d
    real tan2_h;          ///< tan^2 of the angle between n and the half vector h
    real sec2_h;          ///< 1 + tan2_h
    real cos2_d, sin2_d;  ///< of the angle between h and l
    real mirror;          ///< 1 - r.v with r the mirror direction of l: exact where small
    real cos_r;           ///< r.v: exact where it is near 0
    two_floats cos_cos;   ///< cos_i cos_o, the part of l.v along the normal
    two_floats tangent;   ///< sin_i sin_o cos phi, its part in the tangent plane
    real cos_phi;         ///< of phi = phi_o - phi_i
    real out_of_plane;    ///< 1 - |cos phi|: exact where small
#if !ISOTROPIC
    real slope_x, slope_y;    ///< h.x / h.n, h.y / h.n
    real x_i, y_i, x_o, y_o;  ///< tangential parts of l and v
    two_floats x_x, y_y;      ///< l.x v.x, l.y v.y
#endif
} directions;

/// (slope_x / alpha_x)^2 + (slope_y / alpha_y)^2
static inline real stretched_slope2(const directions* d, float alpha_x, float alpha_y)
{
#if ISOTROPIC
    return d->tan2_h * (R(1.0) / (alpha_x * alpha_y));
#else
    return square(d->slope_x * (R(1.0) / alpha_x)) + square(d->slope_y * (R(1.0) / alpha_y));
#endif
}

/// (alpha_x l.x)^2 + (alpha_y l.y)^2 and the same for v
static inline real stretched_sin2_i(const directions* d, float alpha_x, float alpha_y)
{
#if ISOTROPIC
    return square(d->sin_i) * (alpha_x * alpha_y);
#else
    return square(d->x_i * alpha_x) + square(d->y_i * alpha_y);
#endif
}

static inline real stretched_sin2_o(const directions* d, float alpha_x, float alpha_y)
{
#if ISOTROPIC
    return square(d->sin_o) * (alpha_x * alpha_y);
#else
    return square(d->x_o * alpha_x) + square(d->y_o * alpha_y);
#endif
}

#endif

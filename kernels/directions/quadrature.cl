// SPDX-License-Identifier: Apache-2.0
// Nodes of an integral over all v for one l a lane. Half vectors at slope T from the normal, v at
// tan(s/2) = T from the mirror direction, and v at tan(theta/2) = T from the normal all follow from
// T and an azimuth without trigonometry, and the first two set at the same T.
#ifndef GONIO_DIRECTIONS_QUADRATURE
#define GONIO_DIRECTIONS_QUADRATURE
#include "core/math.cl"
#include "directions/directions.cl"
#include "gonio/shared/quadrature_fields.h"

/// The direction that stays.
typedef struct {
    two_floats cosine;
    real sine, cos_phi, sin_phi;
} fixed_direction;

/// A line of nodes at one azimuth: see gonio/shared/quadrature_fields.h.
typedef struct {
    real cosine, sine, frame_cos, frame_sin, scale, from, span, end, weight;
} azimuth_node;

/// Where v is, before it becomes `directions`. sum_along, sum_across: l + v in the plane of
/// incidence and across it.
typedef struct {
    real tangent, q;  ///< T and 1/(1 + T^2)
    real cosine, sum_along, sum_across;
    real weight;  ///< solid angle for a unit of the radial variable
} quadrature_point;

/// T at a value of the radial variable, and its derivative there in *rate.
static inline real radial_tangent(int map, const azimuth_node* node, real t, real* rate)
{
    if (map == map_hemisphere) {
        *rate = R(2.0) * t;
        return R(1.0) - square(t);
    }
    const real s = hyperbolic_sine(t);
    *rate = node->scale * sqrt(R(1.0) + square(s));
    return node->scale * s;
}

/// t: the radial variable.
static inline quadrature_point point_of_node(int map, const fixed_direction* l,
                                             const azimuth_node* node, real t)
{
    quadrature_point p;
    real rate;
    p.tangent = radial_tangent(map, node, t, &rate);
    p.q = R(1.0) / (R(1.0) + square(p.tangent));
    const real twice = R(2.0) * p.q * p.tangent;
    if (map == map_hemisphere) {
        p.cosine = square(t) * (R(1.0) + p.tangent) * p.q;
        p.sum_along = l->sine + twice * node->cosine;
        p.sum_across = twice * node->sine;
        p.weight = twice * R(2.0) * p.q * rate;
        return p;
    }
    // v sets at the root `end` of cos_i T^2 - 2 sin_i cos(azimuth) T - cos_i.
    const real above = max(node->end - p.tangent, node->end * R(1e-7));
    p.cosine = l->cosine.hi * p.q * above * (p.tangent + R(1.0) / node->end);
    const real solid = R(2.0) * p.q * twice * rate;
    if (map == map_half) {
        // cos_i + sin_i cos(azimuth) T is cos theta_d/cos theta_h; v = 2 (l.h) h - l.
        const real facing = l->cosine.hi + l->sine * node->cosine * p.tangent;
        p.sum_along = twice * facing * node->cosine;
        p.sum_across = twice * facing * node->sine;
        p.weight = solid * facing;
    } else {
        p.sum_along = twice * (l->sine * p.tangent + l->cosine.hi * node->cosine);
        p.sum_across = twice * node->sine;
        p.weight = solid;
    }
    return p;
}

/// Polar quantities, from l and v as vectors but where a map has them without cancellation.
static inline void set_polar(directions* d, int map, const fixed_direction* l,
                             const azimuth_node* node, const quadrature_point* p)
{
    const real along = p->sum_along - l->sine;
    const real across2 = square(p->sum_across);
    const two_floats v_n = {p->cosine, (real)(R(0.0))}, l_x = {l->sine, (real)(R(0.0))},
                     v_x = {along, (real)(R(0.0))};
    d->cos_i = l->cosine.hi;
    d->cos_i_lo = l->cosine.lo;
    d->sin_i = l->sine;
    d->cos_o = p->cosine;
    d->cos_o_lo = (real)(R(0.0));
    d->sin_o = sqrt(square(along) + across2);
    d->mean_cos = R(0.5) * (d->cos_i + d->cos_o);
    d->tan2_h = (square(p->sum_along) + across2) / square(R(2.0) * d->mean_cos);
    d->sin2_d = R(0.25) * (square(l->sine - along) + across2 + square(d->cos_i - d->cos_o));
    d->mirror = R(0.5) * (square(p->sum_along) + across2 + square(d->cos_o - d->cos_i));
    d->cos_cos = two_floats_product(l->cosine, v_n);
    d->tangent = two_floats_product(l_x, v_x);
    d->cos_r = two_floats_difference(d->cos_cos, d->tangent);
    if (map == map_half) {
        const real facing = l->cosine.hi + l->sine * node->cosine * p->tangent;
        d->mean_cos = p->q * facing;
        d->tan2_h = square(p->tangent);
    } else if (map == map_mirror) {
        d->mirror = R(2.0) * square(p->tangent) * p->q;
        d->cos_r = (R(1.0) - p->tangent) * (R(1.0) + p->tangent) * p->q;
    }
    d->sec2_h = R(1.0) + d->tan2_h;
    d->cos2_d = square(d->mean_cos) * d->sec2_h;
    const real sine = max(d->sin_o, (real)(R(1e-18)));
    d->cos_phi = clamp(along / sine, (real)(R(-1.0)), (real)(R(1.0)));
    d->out_of_plane = square(p->sum_across / sine) / (R(1.0) + fabs(d->cos_phi));
}

#if !ISOTROPIC
/// Tangential quantities. Half vectors have their azimuth in the tangent frame from the host, so
/// that the narrow side of a ridge is exact.
static inline void set_tangential(directions* d, int map, const fixed_direction* l,
                                  const azimuth_node* node, const quadrature_point* p)
{
    real sum_x = p->sum_along * l->cos_phi - p->sum_across * l->sin_phi;
    real sum_y = p->sum_along * l->sin_phi + p->sum_across * l->cos_phi;
    d->slope_x = sum_x / (R(2.0) * d->mean_cos);
    d->slope_y = sum_y / (R(2.0) * d->mean_cos);
    if (map == map_half) {
        d->slope_x = p->tangent * node->frame_cos;
        d->slope_y = p->tangent * node->frame_sin;
        sum_x = R(2.0) * d->mean_cos * d->slope_x;
        sum_y = R(2.0) * d->mean_cos * d->slope_y;
    }
    d->x_i = l->sine * l->cos_phi;
    d->y_i = l->sine * l->sin_phi;
    d->x_o = sum_x - d->x_i;
    d->y_o = sum_y - d->y_i;
    const two_floats x_i = {d->x_i, (real)(R(0.0))}, y_i = {d->y_i, (real)(R(0.0))};
    const two_floats x_o = {d->x_o, (real)(R(0.0))}, y_o = {d->y_o, (real)(R(0.0))};
    d->x_x = two_floats_product(x_i, x_o);
    d->y_y = two_floats_product(y_i, y_o);
}
#endif

static inline void exchange(real* a, real* b)
{
    const real kept = *a;
    *a = *b;
    *b = kept;
}

/// Light and viewer change places.
static inline void reverse_light(directions* d)
{
    exchange(&d->cos_i, &d->cos_o);
    exchange(&d->cos_i_lo, &d->cos_o_lo);
    exchange(&d->sin_i, &d->sin_o);
#if !ISOTROPIC
    exchange(&d->x_i, &d->x_o);
    exchange(&d->y_i, &d->y_o);
#endif
}

static inline directions directions_of_point(int map, const fixed_direction* l,
                                             const azimuth_node* node, const quadrature_point* p)
{
    directions d;
    set_polar(&d, map, l, node, p);
#if !ISOTROPIC
    set_tangential(&d, map, l, node, p);
#endif
    return d;
}

#endif

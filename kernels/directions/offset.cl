// SPDX-License-Identifier: Apache-2.0
// What a model sees of a fixed light and a viewer that is told relative to the mirror direction.
#ifndef GONIO_DIRECTIONS_OFFSET
#define GONIO_DIRECTIONS_OFFSET
#include "core/sampling.cl"
#include "directions/directions.cl"

/// o = v - r is l + v in the tangent plane and cos_o - cos_i along the normal.
static inline directions directions_of_offset(const fixed_light* l, mirror_offset o)
{
    directions d;
    d.cos_i = (real)(l->cosine);
    d.cos_i_lo = (real)(l->cosine_lo);
    d.sin_i = (real)(l->sine);
    d.cos_o = l->cosine + o.z;
    d.cos_o_lo = (real)(R(0.0));
    const real x_o = o.x - l->x, y_o = o.y - l->y;
    d.sin_o = sqrt(square(x_o) + square(y_o));
    d.mean_cos = l->cosine + R(0.5) * o.z;
    const real sum2 = square(o.x) + square(o.y);
    d.tan2_h = sum2 / square(R(2.0) * d.mean_cos);
    d.sec2_h = R(1.0) + d.tan2_h;
    d.cos2_d = square(d.mean_cos) * d.sec2_h;
    d.sin2_d = R(0.25) * (square(l->x - x_o) + square(l->y - y_o) + square(o.z));
    d.mirror = R(0.5) * (sum2 + square(o.z));
    const two_floats cos_i = {d.cos_i, d.cos_i_lo}, cos_o = {d.cos_o, d.cos_o_lo};
    const two_floats x_l = {(real)(l->x), (real)(R(0.0))}, y_l = {(real)(l->y), (real)(R(0.0))};
    const two_floats x_v = {x_o, (real)(R(0.0))}, y_v = {y_o, (real)(R(0.0))};
    const two_floats x_x = two_floats_product(x_l, x_v), y_y = two_floats_product(y_l, y_v);
    d.cos_cos = two_floats_product(cos_i, cos_o);
    d.tangent = two_floats_plus(x_x, y_y);
    d.cos_r = two_floats_difference(d.cos_cos, d.tangent);
    const real over_sin_sin = R(1.0) / max(d.sin_i * d.sin_o, (real)(R(1e-30)));
    d.cos_phi = clamp(d.tangent.hi * over_sin_sin, (real)(R(-1.0)), (real)(R(1.0)));
    d.out_of_plane = square((l->x * y_o - l->y * x_o) * over_sin_sin) / (R(1.0) + fabs(d.cos_phi));
#if !ISOTROPIC
    const real scale = R(0.5) / d.mean_cos;
    d.slope_x = o.x * scale;
    d.slope_y = o.y * scale;
    d.x_i = (real)(l->x);
    d.y_i = (real)(l->y);
    d.x_o = x_o;
    d.y_o = y_o;
    d.x_x = x_x;
    d.y_y = y_y;
#endif
    return d;
}

#endif

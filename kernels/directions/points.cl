// SPDX-License-Identifier: Apache-2.0
// Lists of points: one row, whose quantities the host has prepared.
#ifndef GONIO_DIRECTIONS_POINTS
#define GONIO_DIRECTIONS_POINTS
#include "directions/directions.cl"
#include "gonio/shared/grid_fields.h"

#define GRID_ARGUMENTS global const float* restrict points
#define GRID_VALUES points

typedef struct {
    global const float* points;
    uint length;
} grid_row;

static inline grid_row row_of_grid(GRID_ARGUMENTS, uint length, ulong index)
{
    const grid_row row = {points, length};
    return row;
}

static inline directions directions_of_cell(const grid_row* row, uint at)
{
    directions d;
#define POINT_FIELD(name) load(row->points + (ulong)point_##name * row->length + at)
    d.cos_i = POINT_FIELD(cos_i);
    d.cos_o = POINT_FIELD(cos_o);
    d.cos_i_lo = POINT_FIELD(cos_i_lo);
    d.cos_o_lo = POINT_FIELD(cos_o_lo);
    d.sin_i = POINT_FIELD(sin_i);
    d.sin_o = POINT_FIELD(sin_o);
    d.mean_cos = R(0.5) * (d.cos_i + d.cos_o);
    d.tan2_h = POINT_FIELD(tan2_h);
    d.sec2_h = R(1.0) + d.tan2_h;
    d.cos2_d = POINT_FIELD(cos2_d);
    d.sin2_d = POINT_FIELD(sin2_d);
    d.mirror = POINT_FIELD(mirror);
    d.cos_r = POINT_FIELD(cos_r);
    const two_floats cos_cos = {POINT_FIELD(cos_cos_hi), POINT_FIELD(cos_cos_lo)};
    const two_floats tangent = {POINT_FIELD(tangent_hi), POINT_FIELD(tangent_lo)};
    d.cos_cos = cos_cos;
    d.tangent = tangent;
    d.cos_phi = POINT_FIELD(cos_phi);
    d.out_of_plane = POINT_FIELD(out_of_plane);
#if !ISOTROPIC
    d.slope_x = POINT_FIELD(slope_x);
    d.slope_y = POINT_FIELD(slope_y);
    d.x_i = POINT_FIELD(x_i);
    d.y_i = POINT_FIELD(y_i);
    d.x_o = POINT_FIELD(x_o);
    d.y_o = POINT_FIELD(y_o);
    const two_floats x_x = {POINT_FIELD(x_x_hi), POINT_FIELD(x_x_lo)};
    const two_floats y_y = {POINT_FIELD(y_y_hi), POINT_FIELD(y_y_lo)};
    d.x_x = x_x;
    d.y_y = y_y;
#endif
#undef POINT_FIELD
    return d;
}

#endif

// SPDX-License-Identifier: Apache-2.0
// Grids over (theta_i, phi_i, theta_o, phi_o), and over (theta_i, theta_o, delta phi) with one
// phi_i. A row runs over phi_o.
#ifndef GONIO_DIRECTIONS_SPHERICAL
#define GONIO_DIRECTIONS_SPHERICAL
#include "directions/directions.cl"
#include "gonio/shared/grid_fields.h"

/// Tables as gonio/shared/grid_fields.h describes them.
#define GRID_ARGUMENTS                                                                     \
    global const float *restrict theta, global const float *restrict phi,                  \
        global const float *restrict tangent_in, global const float *restrict tangent_out, \
        const uint count_phi_i, const uint count_theta_o
#define GRID_VALUES theta, phi, tangent_in, tangent_out, count_phi_i, count_theta_o

typedef struct {
    global const float *theta, *phi, *tangent_in, *tangent_out;
    uint length;
} grid_row;

static inline grid_row row_of_grid(GRID_ARGUMENTS, uint length, ulong index)
{
    const uint o = (uint)(index % count_theta_o);
    const ulong incoming = index / count_theta_o;
    const uint a = (uint)(incoming % count_phi_i);
    const uint i = (uint)(incoming / count_phi_i);
    const grid_row row = {theta + ((ulong)i * count_theta_o + o) * theta_fields,
                          phi + (ulong)a * phi_fields * length,
                          tangent_in + incoming * tangent_fields,
                          tangent_out + (ulong)o * tangent_fields * length, length};
    return row;
}

#define ROW_FIELD(name) ((real)(row->theta[theta_##name]))
#define COLUMN_FIELD(name) load(row->phi + (ulong)phi_##name * row->length + at)

static inline directions directions_of_cell(const grid_row* row, uint at)
{
    directions d;
    d.cos_i = ROW_FIELD(cos_i);
    d.cos_o = ROW_FIELD(cos_o);
    d.cos_i_lo = ROW_FIELD(cos_i_lo);
    d.cos_o_lo = ROW_FIELD(cos_o_lo);
    d.sin_i = ROW_FIELD(sin_i);
    d.sin_o = ROW_FIELD(sin_o);
    const two_floats sin_sin = {ROW_FIELD(sin_sin_hi), ROW_FIELD(sin_sin_lo)};
    const two_floats cos_cos = {ROW_FIELD(cos_cos_hi), ROW_FIELD(cos_cos_lo)};
    const two_floats cos_delta = {COLUMN_FIELD(cos_delta_hi), COLUMN_FIELD(cos_delta_lo)};
    const real cos2_half = COLUMN_FIELD(cos2_half_delta);
    const real sin2_half = COLUMN_FIELD(sin2_half_delta);

    // Sums of squares: with d = theta_i - theta_o and S = theta_i + theta_o
    // tan^2 theta_h = tan^2(d/2) sin^2(delta/2) + tan^2(S/2) cos^2(delta/2), and likewise for the
    // others.
    d.tan2_h =
        fma(ROW_FIELD(tan2_half_difference), sin2_half, ROW_FIELD(tan2_half_sum) * cos2_half);
    d.cos2_d = ROW_FIELD(cos2_half_sum) + sin_sin.hi * cos2_half;
    // cos theta_h cos theta_d = (cos_i + cos_o)/2, since l + v = 2 cos theta_d h: no division in
    // the loop.
    d.mean_cos = R(0.5) * (d.cos_i + d.cos_o);
    d.sec2_h = d.cos2_d * (R(1.0) / square(d.mean_cos));
    d.sin2_d = ROW_FIELD(sin2_half_difference) + sin_sin.hi * sin2_half;
    d.mirror = R(2.0) * (ROW_FIELD(sin2_half_difference) + sin_sin.hi * cos2_half);
    d.cos_cos = cos_cos;
    d.tangent = two_floats_product(sin_sin, cos_delta);
    d.cos_r = two_floats_less_product(cos_cos, sin_sin, cos_delta);
    d.cos_phi = cos_delta.hi;
    d.out_of_plane = R(2.0) * min(cos2_half, sin2_half);
#if !ISOTROPIC
    const two_floats x_i = {(real)(row->tangent_in[tangent_x_hi]),
                            (real)(row->tangent_in[tangent_x_lo])};
    const two_floats y_i = {(real)(row->tangent_in[tangent_y_hi]),
                            (real)(row->tangent_in[tangent_y_lo])};
#define TANGENT_FIELD(name) load(row->tangent_out + (ulong)tangent_##name * row->length + at)
    const two_floats x_o = {TANGENT_FIELD(x_hi), TANGENT_FIELD(x_lo)};
    const two_floats y_o = {TANGENT_FIELD(y_hi), TANGENT_FIELD(y_lo)};
#undef TANGENT_FIELD
    const real scale = R(1.0) / (d.cos_i + d.cos_o);
    d.slope_x = two_floats_sum(x_i, x_o) * scale;
    d.slope_y = two_floats_sum(y_i, y_o) * scale;
    d.x_i = x_i.hi;
    d.y_i = y_i.hi;
    d.x_o = x_o.hi;
    d.y_o = y_o.hi;
    d.x_x = two_floats_product(x_i, x_o);
    d.y_y = two_floats_product(y_i, y_o);
#endif
    return d;
}

#undef ROW_FIELD
#undef COLUMN_FIELD
#endif

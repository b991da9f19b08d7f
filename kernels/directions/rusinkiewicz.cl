// SPDX-License-Identifier: Apache-2.0
// Grids over (theta_h, theta_d, phi_d) with the half vector at azimuth 0 (Rusinkiewicz, EGWR 1998),
// for isotropic materials. A row runs over phi_d. Cells with a direction below the horizon exist;
// they are 0.
#ifndef GONIO_DIRECTIONS_RUSINKIEWICZ
#define GONIO_DIRECTIONS_RUSINKIEWICZ
#ifndef ISOTROPIC
#define ISOTROPIC 1
#endif
#if !ISOTROPIC
#error "a grid of half vectors has no tangent frame"
#endif
#include "directions/directions.cl"
#include "gonio/shared/grid_fields.h"

/// Cosines up to here count as below the horizon: rusinkiewicz_horizon of gonio/grid.hpp.
#define HORIZON R(1e-7)

#define GRID_ARGUMENTS \
    global const float* restrict half_table, global const float* restrict difference_table
#define GRID_VALUES half_table, difference_table

typedef struct {
    global const float *half_record, *difference_table;
    uint length;
} grid_row;

static inline grid_row row_of_grid(GRID_ARGUMENTS, uint length, ulong index)
{
    const grid_row row = {half_table + index * half_fields, difference_table, length};
    return row;
}

#define ROW_FIELD(name) ((real)(row->half_record[half_##name]))
#define COLUMN_FIELD(name) load(row->difference_table + (ulong)difference_##name * row->length + at)

static inline directions directions_of_cell(const grid_row* row, uint at)
{
    directions d;
    const real sin_h = ROW_FIELD(sin_h);
    const real cos_h = ROW_FIELD(cos_h);
    const real sin_d = ROW_FIELD(sin_d);
    const real cos_d = ROW_FIELD(cos_d);
    const two_floats cos_phi = {COLUMN_FIELD(cos_hi), COLUMN_FIELD(cos_lo)};
    const real sin_phi = COLUMN_FIELD(sin);

    // n.l, n.v = cos_h cos_d -+ sin_h sin_d cos phi_d: in two floats, since they vanish at the
    // horizon.
    const two_floats cos_cos = {ROW_FIELD(cos_cos_hi), ROW_FIELD(cos_cos_lo)};
    const two_floats sin_sin = {ROW_FIELD(sin_sin_hi), ROW_FIELD(sin_sin_lo)};
    const two_floats swing = two_floats_product(sin_sin, cos_phi);
    const two_floats cos_i = two_floats_minus(cos_cos, swing);
    const two_floats cos_o = two_floats_plus(cos_cos, swing);
    d.cos_i = cos_i.hi;
    d.cos_o = cos_o.hi;
    d.cos_i_lo = cos_i.lo;
    d.cos_o_lo = cos_o.lo;
    d.mean_cos = cos_cos.hi;

    // l and v = (sin_h cos_d +- cos_h sin_d cos phi_d, +- sin_d sin phi_d) in the tangent plane.
    const real along = sin_h * cos_d;
    const real swing_x = cos_h * sin_d * cos_phi.hi;
    const real swing_y = sin_d * sin_phi;
    d.sin_i = sqrt(square(along + swing_x) + square(swing_y));
    d.sin_o = sqrt(square(along - swing_x) + square(swing_y));
    d.tan2_h = ROW_FIELD(tan2_h);
    d.sec2_h = R(1.0) + d.tan2_h;
    d.cos2_d = square(cos_d);
    d.sin2_d = square(sin_d);
    // 1 - r.v = 2 sin^2 theta_h (cos^2 theta_d + sin^2 theta_d cos^2 phi_d)
    d.mirror = R(2.0) * square(sin_h) * (square(cos_d) + square(sin_d * cos_phi.hi));
    // l.v = cos 2 theta_d, and r.v = 2 (n.l)(n.v) - l.v.
    const two_floats l_v = {ROW_FIELD(l_v_hi), ROW_FIELD(l_v_lo)};
    d.cos_cos =
        two_floats_minus(two_floats_product(cos_cos, cos_cos), two_floats_product(swing, swing));
    d.tangent = two_floats_minus(l_v, d.cos_cos);
    d.cos_r = two_floats_difference(d.cos_cos, d.tangent);
    // The azimuth between l and v has no cancellation in its sine: l x v = 2 along swing_y.
    const real over_sin_sin = R(1.0) / max(d.sin_i * d.sin_o, (real)(R(1e-30)));
    d.cos_phi = clamp(d.tangent.hi * over_sin_sin, (real)(R(-1.0)), (real)(R(1.0)));
    d.out_of_plane = square(R(2.0) * along * swing_y * over_sin_sin) / (R(1.0) + fabs(d.cos_phi));
    return d;
}

#undef ROW_FIELD
#undef COLUMN_FIELD
#endif

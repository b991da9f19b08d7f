// SPDX-License-Identifier: Apache-2.0
// What the host prepares in double for the direction grids, read by C++ and by OpenCL C: the order
// of the fields. Pairs of fields named _hi and _lo are one number in two floats.
#ifndef GONIO_GRID_FIELDS
#define GONIO_GRID_FIELDS

/// Per pair (theta_i, theta_o): one record after the other. Differences are made in double, so that
/// no kernel subtracts.
enum theta_field {
    theta_cos_i,
    theta_cos_o,
    theta_cos_i_lo,
    theta_cos_o_lo,
    theta_sin_i,
    theta_sin_o,
    theta_tan2_half_difference,
    theta_tan2_half_sum,
    theta_cos2_half_sum,
    theta_sin2_half_difference,
    theta_cos_cos_hi,
    theta_cos_cos_lo,
    theta_sin_sin_hi,
    theta_sin_sin_lo,
    theta_fields
};

/// Per pair (phi_i, phi_o): for each phi_i one run over phi_o per field. delta = phi_o - phi_i.
enum phi_field {
    phi_cos2_half_delta,
    phi_sin2_half_delta,
    phi_cos_delta_hi,
    phi_cos_delta_lo,
    phi_fields
};

/// Per direction: its part in the tangent plane. Incoming: one record per (theta_i, phi_i);
/// outgoing: for each theta_o one run over phi_o per field.
enum tangent_field { tangent_x_hi, tangent_x_lo, tangent_y_hi, tangent_y_lo, tangent_fields };

/// Rusinkiewicz grids, per pair (theta_h, theta_d): one record after the other.
enum half_field {
    half_sin_h,
    half_cos_h,
    half_sin_d,
    half_cos_d,
    half_tan2_h,
    half_cos_cos_hi,
    half_cos_cos_lo,
    half_sin_sin_hi,
    half_sin_sin_lo,
    half_l_v_hi,
    half_l_v_lo,
    half_fields
};

/// Rusinkiewicz grids, per phi_d: one run per field.
enum difference_field { difference_cos_hi, difference_cos_lo, difference_sin, difference_fields };

/// Lists of points: one run over the points per field, the same quantities that
/// kernels/directions/directions.cl names.
enum point_field {
    point_cos_i,
    point_cos_o,
    point_cos_i_lo,
    point_cos_o_lo,
    point_sin_i,
    point_sin_o,
    point_tan2_h,
    point_cos2_d,
    point_sin2_d,
    point_mirror,
    point_cos_r,
    point_cos_cos_hi,
    point_cos_cos_lo,
    point_tangent_hi,
    point_tangent_lo,
    point_cos_phi,
    point_out_of_plane,
    point_slope_x,
    point_slope_y,
    point_x_i,
    point_y_i,
    point_x_o,
    point_y_o,
    point_x_x_hi,
    point_x_x_lo,
    point_y_y_hi,
    point_y_y_lo,
    point_fields
};

#endif

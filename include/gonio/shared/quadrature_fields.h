// SPDX-License-Identifier: Apache-2.0
// What the host prepares in double for integrals over the hemisphere, read by C++ and by OpenCL C:
// the order of the fields. Fields named _hi and _lo are one number in two floats.
#ifndef GONIO_QUADRATURE_FIELDS
#define GONIO_QUADRATURE_FIELDS

/// How nodes lie about a direction l: in slopes of the half vector, about the mirror direction in
/// tan(angle/2), or about the normal in tan(theta/2).
enum quadrature_map { map_half, map_mirror, map_hemisphere };

/// Per cell, a direction with its azimuth in the tangent frame: one lane of each field.
enum cell_field { cell_cos_hi, cell_cos_lo, cell_sin, cell_cos_phi, cell_sin_phi, cell_fields };

/// Per node of the azimuth, from the plane of incidence and in the tangent frame: the line of
/// radial nodes there. from, span: of the radial variable; end: the tangent at which v sets.
enum node_field {
    node_cos,
    node_sin,
    node_frame_cos,
    node_frame_sin,
    node_scale,
    node_from,
    node_span,
    node_end,
    node_weight,
    node_fields
};

/// Per group of lanes: its row of parameters, its first node and their number.
enum group_field { group_row, group_first, group_count, group_fields };

#endif

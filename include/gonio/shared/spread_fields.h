// SPDX-License-Identifier: Apache-2.0
// What the kernel of light below a surface exchanges with the host, read by C++ and by OpenCL C.
#ifndef GONIO_SPREAD_FIELDS
#define GONIO_SPREAD_FIELDS

/// Planes of a picture: where its pixels lie in space, and in which column; -1 where there is no
/// surface.
enum place_plane { place_x, place_y, place_z, place_column, place_planes };

/// Light enters a block of pixels: its mean place, light times area, area.
enum block_field {
    block_x,
    block_y,
    block_z,
    block_red,
    block_green,
    block_blue,
    block_area,
    block_fields
};

#endif

// SPDX-License-Identifier: Apache-2.0
// Light that spreads below a surface seen in a picture: at each pixel the mean of what enters the
// blocks around it, weighted by a Gaussian of the distance in space and by area.
#include "core/math.cl"
#include "gonio/shared/spread_fields.h"

/// out: [channel][pixel], 3 channels, 0 where there is no surface. places: [place plane][pixel];
/// rows have `width` pixels, at least WIDTH. blocks: [row][column][block field]; a block is
/// stride x stride pixels. Those up to `radius` rows and columns from a pixel's own count. falloff:
/// 1/(2 variance); beyond q = 80 it does not fall, so that some weight is always left. All lanes
/// walk over the same blocks and leave out those that are too far from theirs, so that sums have
/// the same order at every width.
kernel void spread(global float* restrict out, global const float* restrict places,
                   global const float* restrict blocks, const uint width, const uint height,
                   const uint columns, const uint rows, const uint stride, const uint radius,
                   const float falloff)
{
    const ulong plane = (ulong)width * height;
    for (uint y = (uint)get_global_id(0); y < height; y += (uint)get_global_size(0)) {
        const uint first_row = y / stride - min(y / stride, radius);
        const uint last_row = min(rows - 1, y / stride + radius);
        for (uint begin = 0; begin < width; begin += WIDTH) {
            const uint x = min(begin, width - WIDTH);
            const ulong pixel = (ulong)y * width + x;
            const real column = load(places + place_column * plane + pixel);
            real sums[3] = {(real)(R(0.0)), (real)(R(0.0)), (real)(R(0.0))}, area = (real)(R(0.0));
            const mask_t surface = less((real)(R(-0.5)), column);
            if (any_of(surface)) {
                const real px = load(places + place_x * plane + pixel);
                const real py = load(places + place_y * plane + pixel);
                const real pz = load(places + place_z * plane + pixel);
                const real own = floor(column / (float)stride);
                const uint first = x / stride - min(x / stride, radius);
                const uint last = min(columns - 1, (x + WIDTH - 1) / stride + radius);
                for (uint row = first_row; row <= last_row; ++row)
                    for (uint c = first; c <= last; ++c) {
                        global const float* block =
                            blocks + ((ulong)row * columns + c) * block_fields;
                        if (block[block_area] == 0.0f) continue;
                        const real distance2 = square(px - block[block_x]) +
                                               square(py - block[block_y]) +
                                               square(pz - block[block_z]);
                        const mask_t near =
                            less(fabs(own - (float)c), (real)((float)radius + 0.5f));
                        const real weight =
                            choose(near, exp_of_negative(min(distance2 * falloff, (real)(R(80.0)))),
                                   (real)(R(0.0)));
                        for (uint k = 0; k < 3; ++k)
                            sums[k] = fma(weight, (real)(block[block_red + k]), sums[k]);
                        area = fma(weight, (real)(block[block_area]), area);
                    }
            }
            for (uint k = 0; k < 3; ++k)
                store(choose(surface, sums[k] / area, (real)(R(0.0))), out + k * plane + pixel);
        }
    }
}

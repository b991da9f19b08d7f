// SPDX-License-Identifier: Apache-2.0
// Grid cell -> directions -> BRDF -> output, for a tile of rows. The program's first lines, written
// by the host, include the grid and choose the material (see core/material.cl); options say which
// symmetries hold:
//   - MIRROR: the columns are symmetric about their middle: half of them are computed and stored
//     twice
//   - RECIPROCAL: rows (i, o) and (o, i) agree: where both are in the tile, one is computed and
//     stored twice
#ifndef GRID_ARGUMENTS
#include "directions/spherical.cl"
#endif
#include "core/material.cl"

#ifndef MIRROR
#define MIRROR 0
#endif
#ifndef RECIPROCAL
#define RECIPROCAL 0
#endif

/// out: [channel][row of the tile][column]. Dimension 0 of the work shares columns, dimension 1
/// rows. length: columns, at least WIDTH (twice that with MIRROR): a row's last vector overlaps its
/// neighbour instead of passing the end.
kernel void table(global float* restrict out, global const float* restrict parameters,
                  const uint length, const ulong first_row, const ulong row_count, GRID_ARGUMENTS)
{
    material m;
    load_material(&m, parameters);

    const uint columns = MIRROR ? (length + 1) / 2 : length;
    const ulong begin = row_count * get_global_id(1) / get_global_size(1);
    const ulong end = row_count * (get_global_id(1) + 1) / get_global_size(1);
    for (ulong r = begin; r < end; ++r) {
#if RECIPROCAL
        ulong twin = r;
        const ulong i = (first_row + r) / count_theta_o;
        const ulong o = (first_row + r) % count_theta_o;
        const ulong first_i = first_row / count_theta_o;
        if (o >= first_i && o < first_i + row_count / count_theta_o) {
            if (o < i) continue;
            twin = (o - first_i) * count_theta_o + i;
        }
#endif
        const grid_row row = row_of_grid(GRID_VALUES, length, first_row + r);
        for (uint column = (uint)get_global_id(0) * WIDTH; column < columns;
             column += (uint)get_global_size(0) * WIDTH) {
            const uint at = min(column, columns - WIDTH);
            const directions d = directions_of_cell(&row, at);
            real f[CHANNELS];
            evaluate_material(&m, &d, f);
            FOR_CHANNELS(c)
            {
#ifdef HORIZON
                const mask_t above =
                    less((real)(HORIZON), d.cos_i) & less((real)(HORIZON), d.cos_o);
                f[c] = choose(above, f[c], (real)(R(0.0)));
#endif
                global float* to = out + ((ulong)c * row_count + r) * length;
                store(f[c], to + at);
                if (MIRROR) store(reversed(f[c]), to + (length - WIDTH - at));
#if RECIPROCAL
                to = out + ((ulong)c * row_count + twin) * length;
                if (twin != r) {
                    store(f[c], to + at);
                    if (MIRROR) store(reversed(f[c]), to + (length - WIDTH - at));
                }
#endif
            }
        }
    }
}

// SPDX-License-Identifier: Apache-2.0
// Linear interpolation in a residual grid over Rusinkiewicz's angles: parameters of kind TABLE.
#ifndef GONIO_CORE_RESIDUAL
#define GONIO_CORE_RESIDUAL
#include "core/math.cl"
#include "directions/directions.cl"
#include "gonio/shared/residual_fields.h"

/// The lower sample of a cell on one axis, and the share of the upper one.
typedef struct {
    mask_t sample;
    real share;
} residual_cell;

/// place: counted in samples, 0 or more; held at the last one.
static inline residual_cell residual_cell_at(real place, int count)
{
    const real last = (real)((float)(count - 2));
    const real whole = min(floor(place), last);
    const residual_cell cell = {int_of(whole), min(place - whole, (real)(R(1.0)))};
    return cell;
}

/// The angle of that sine and cosine on an axis whose sample 0 is at 0, sample 1 at `first` and the
/// others `step` apart. Beyond 45 degrees it is counted from the last sample by what it lacks to 90
/// degrees: towards the horizon f is steep.
static inline residual_cell residual_theta(real sine, real cosine, global const float* grid,
                                           int axis)
{
    const int count = (int)grid[residual_count + axis];
    const int root = axis == 0 && grid[residual_root] != R(0.0);
    const float first = grid[residual_first + axis], last = grid[residual_last + axis],
                inverse_step = grid[residual_inverse_step + axis];

    const mask_t is_steep = less(cosine, sine);
    const real lesser = angle_of(min(sine, cosine), max(sine, cosine));
    const real theta = choose(is_steep, R(0.5) * PI - lesser, lesser);
    const real place = root ? sqrt(theta) : theta;
    const real even = fma(place - first, (real)(inverse_step), (real)(R(1.0)));
    const residual_cell up =
        residual_cell_at(choose(less(place, (real)(first)), place * (R(1.0) / first), even), count);

    const real lacking = lesser - grid[residual_rest + axis];
    const real down =
        max((root ? lacking / (place + last) : lacking) * inverse_step, (real)(R(0.0)));
    const mask_t from_last = is_steep & less(down, (real)((float)(count - 2)));
    const real whole = floor(down);
    const residual_cell cell = {
        (from_last & (count - 2 - int_of(whole))) | (not_(from_last) & up.sample),
        choose(from_last, R(1.0) - (down - whole), up.share)};
    return cell;
}

static inline real residual_between(real share, real lower, real upper)
{
    return fma(share, upper - lower, lower);
}

typedef struct {
    global const float* values;  ///< of the first channel; none if plane is 0
    int plane, channels;
    int row, slab;  ///< samples to the next theta_d and theta_h
    mask_t at;      ///< the lowest corner
    real share_h, share_d, share_phi;
} residual_place;

/// |n.(l x v)| = 2 cos theta_d sin theta_d sin theta_h |sin phi_d| = sin_i sin_o |sin phi|, and
/// cos_o - cos_i = 2 sin theta_h sin theta_d cos phi_d: no angle is lost where it is small.
static inline residual_place residual_place_of(global const float* grid, const directions* d)
{
    residual_place place;
    place.plane = (int)grid[residual_plane];
    place.channels = (int)grid[residual_channels];
    place.values = grid + residual_values;
    if (place.plane == 0) return place;

    const real cos_d = sqrt(d->cos2_d);
    const real across = d->sin_i * d->sin_o * sqrt(d->out_of_plane * (R(2.0) - d->out_of_plane));
    const real along = fabs((d->cos_o - d->cos_i) + (d->cos_o_lo - d->cos_i_lo)) * cos_d;
    const real phi_d = angle_of(across, max(along, (real)(R(1e-37))));

    const int count_d = (int)grid[residual_count + 1], count_phi = (int)grid[residual_count + 2];
    const residual_cell h = residual_theta(sqrt(d->tan2_h), (real)(R(1.0)), grid, 0);
    const residual_cell cell_d = residual_theta(sqrt(d->sin2_d), cos_d, grid, 1);
    const real phi_place = (phi_d - grid[residual_first + 2]) * grid[residual_inverse_step + 2];
    const residual_cell phi = residual_cell_at(max(phi_place, (real)(R(0.0))), count_phi);
    place.row = count_phi;
    place.slab = count_d * count_phi;
    place.at = h.sample * place.slab + cell_d.sample * place.row + phi.sample;
    place.share_h = h.share;
    place.share_d = cell_d.share;
    place.share_phi = phi.share;
    return place;
}

static inline real residual_on_row(const residual_place* place, global const float* from)
{
    return residual_between(place->share_phi, gather(from, place->at), gather(from + 1, place->at));
}

static inline real residual_on_slab(const residual_place* place, global const float* from)
{
    return residual_between(place->share_d, residual_on_row(place, from),
                            residual_on_row(place, from + place->row));
}

/// The residual: a logarithm. A grid of one channel serves all.
static inline real residual_at(const residual_place* place, int channel)
{
    if (place->plane == 0) return (real)(R(0.0));
    global const float* from = place->values + min(channel, place->channels - 1) * place->plane;
    return residual_between(place->share_h, residual_on_slab(place, from),
                            residual_on_slab(place, from + place->slab));
}

#endif

// SPDX-License-Identifier: Apache-2.0
// What photons do at the end of a layer: they are reflected, cross, or leave.
#ifndef GONIO_PHOTON_BOUNDARY
#define GONIO_PHOTON_BOUNDARY
#include "photon/spectrum.cl"

typedef struct {
    real reflectance, cosine;  ///< cosine: behind the boundary
} refraction;

/// Unpolarised light (Born and Wolf 1.5.2) of this cosine; ratio: the index here over that behind,
/// excess: 1 - ratio^2.
static inline refraction refracted(real cosine, real ratio, real excess)
{
    const real cosine2 = fma(square(ratio), square(cosine), excess);
    const real behind = sqrt(max(cosine2, (real)(R(0.0))));
    const real s_over = fma(ratio, cosine, -behind), s_under = fma(ratio, cosine, behind);
    const real p_over = fma(ratio, behind, -cosine), p_under = fma(ratio, behind, cosine);
    const real sum = square(s_over * p_under) + square(p_over * s_under);
    const real part = R(0.5) * sum / square(s_under * p_under);
    const refraction result = {choose(less((real)(R(0.0)), cosine2), part, (real)(R(1.0))), behind};
    return result;
}

#if BOTTOM != 0
/// The lanes of a mask arrive at a bottom that is not open; the tallies get what it absorbs.
static inline void meet_bottom(packet* p, mask_t lanes, word bits_cosine, word bits_azimuth,
                               float albedo, const scene* s)
{
#if BOTTOM == 1
    p->u.z = choose(lanes, -p->u.z, p->u.z);
#else
    const real reflected = fma(real_of(p->weight), (real)(albedo), (real)(R(0.5)));
    const word kept = min(word_of(reflected), p->weight);
    const real sine2 = uniform_of(bits_cosine);
    const azimuth about = even_azimuth(bits_azimuth);
    p->u.x = choose(lanes, sqrt(sine2) * about.cosine, p->u.x);
    p->u.y = choose(lanes, sqrt(sine2) * about.sine, p->u.y);
    p->u.z = choose(lanes, -sqrt(R(1.0) - sine2), p->u.z);
    p->scattered |= lanes;
    count_total(p->weight - kept, lanes, total_bottom, s);
    p->weight = choose_word(lanes, kept, p->weight);
#endif
#if CLEAR_TOP
    p->met_matter |= lanes;
#endif
}
#endif

#if REFLECTED || TRANSMITTED
/// The row of the bins in which light leaves.
static inline word exit_row(const packet* p, const scene* s)
{
#if ROW == 0
    return radius_bin(p->x, p->y, s->row_bins_per_unit, ROWS);
#elif ROW == 1
    return azimuth_bin(p->u.x, p->u.y, ROWS);
#else
    return bin_of(p->optical_path, s->row_bins_per_unit, ROWS);
#endif
}

/// Adds what leaves to bins [row][angle] that begin at `first`.
static inline void count_exits(const packet* p, mask_t lanes, uint first, const scene* s)
{
    const real sine = sqrt(fma(p->u.x, p->u.x, square(p->u.y)));
    const word bins = exit_row(p, s) * ANGLES + angle_bin(sine, fabs(p->u.z), ANGLES);
    add_weights(s->tallies, first, bins, choose_word(lanes, p->weight, (word)(0)));
}
#endif

/// The lanes of a mask leave upwards; `specular` are those that have met nothing.
static inline void leave_above(packet* p, mask_t lanes, const scene* s)
{
#if CLEAR_TOP
    count_total(p->weight, lanes & not_(p->met_matter), total_specular, s);
    lanes &= p->met_matter;
#endif
    count_total(p->weight, lanes, total_reflected, s);
#if REFLECTED
#if ROW == 1
    lanes &= p->scattered;
#endif
    count_exits(p, lanes, FIRST_REFLECTED, s);
#endif
#if SPECTRUM
    count_spectrum(p, lanes, s);
#endif
}

static inline void leave_below(packet* p, mask_t lanes, const scene* s)
{
    count_total(p->weight, lanes & not_(p->scattered), total_unscattered, s);
    count_total(p->weight, lanes & p->scattered, total_transmitted, s);
#if TRANSMITTED
#if ROW == 1
    lanes &= p->scattered;
#endif
    count_exits(p, lanes, FIRST_TRANSMITTED, s);
#endif
}

/// The lanes of a mask have arrived at the end of their layer.
static inline void meet_boundary(packet* p, mask_t lanes, word bits_cosine, word bits_azimuth,
                                 float bottom_albedo, const scene* s)
{
    count_deposits(p, lanes, s);
#if SPECTRUM
    end_paths(p, lanes);
#endif
    const mask_t up = less(p->u.z, (real)(R(0.0)));
    p->z = choose(lanes, choose(up, (real)(R(0.0)), p->thickness), p->z);
#if BOTTOM != 0
    const mask_t at_bottom = lanes & not_(up) & equal(p->layer, (mask_t)(LAYERS - 1));
    if (any_of(at_bottom)) meet_bottom(p, at_bottom, bits_cosine, bits_azimuth, bottom_albedo, s);
    lanes &= not_(at_bottom);
#endif
    real ratio = (real)(R(1.0)), excess = (real)(R(0.0));
#define UP_OR_DOWN(k, field) \
    choose(up, (real)(layer_value(s, k, field##_up)), (real)(layer_value(s, k, field##_down)))
#define LOOK_UP_BOUNDARY(k)                                         \
    {                                                               \
        const mask_t here = equal(p->layer, (mask_t)(k));           \
        ratio = choose(here, UP_OR_DOWN(k, layer_ratio), ratio);    \
        excess = choose(here, UP_OR_DOWN(k, layer_excess), excess); \
    }
    EACH_LAYER(LOOK_UP_BOUNDARY)
    const refraction at = refracted(fabs(p->u.z), ratio, excess);
    const mask_t reflects = lanes & less(uniform_of(bits_cosine), at.reflectance);
    const mask_t crosses = lanes & not_(reflects);
    p->u.x = choose(crosses, p->u.x * ratio, p->u.x);
    p->u.y = choose(crosses, p->u.y * ratio, p->u.y);
    p->u.z = choose(crosses, copysign(at.cosine, p->u.z), choose(reflects, -p->u.z, p->u.z));

    const mask_t leaves_up = crosses & up & equal(p->layer, (mask_t)(0));
    if (any_of(leaves_up)) leave_above(p, leaves_up, s);
    const mask_t leaves_down = crosses & not_(up) & equal(p->layer, (mask_t)(LAYERS - 1));
    if (any_of(leaves_down)) leave_below(p, leaves_down, s);
    const mask_t leaves = leaves_up | leaves_down;
    p->weight = choose_word(leaves, (word)(0), p->weight);

#if LAYERS > 1
    const mask_t enters = crosses & not_(leaves);
    p->layer = choose_count(enters, choose_count(up, p->layer - 1, p->layer + 1), p->layer);
    look_up_layer(p, enters, s);
    p->z = choose(enters, choose(up, p->thickness, (real)(R(0.0))), p->z);
#endif
}

#endif

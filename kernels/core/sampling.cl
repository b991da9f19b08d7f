// SPDX-License-Identifier: Apache-2.0
// Random viewers for a fixed light: where they are told relative to its mirror direction, so that
// narrow highlights keep their digits.
#ifndef GONIO_CORE_SAMPLING
#define GONIO_CORE_SAMPLING
#include "core/random.cl"

/// The direction to the light, which every sampler and every pdf takes as given.
typedef struct {
    float cosine, cosine_lo, sine, cos_phi, sin_phi;
    float x, y;
} fixed_light;

/// v - r for a viewer v and the mirror direction r = (-l.x, -l.y, l.z).
typedef struct {
    real x, y, z;
} mirror_offset;

/// A half vector of any length, z > 0.
typedef struct {
    real x, y, z;
} half_vector;

/// v = 2 (l.h) h - l. Below the horizon where l.h < 0.
static inline mirror_offset reflected(const fixed_light* l, half_vector h)
{
    const real across2 = square(h.x) + square(h.y);
    const real tangential = l->x * h.x + l->y * h.y;
    const real scale = R(2.0) / (across2 + square(h.z));
    const real facing = scale * (tangential + l->cosine * h.z);
    const mirror_offset o = {facing * h.x, facing * h.y,
                             scale * (tangential * h.z - l->cosine * across2)};
    return o;
}

/// At an angle from the mirror direction of which 1 - cos is known.
static inline mirror_offset about_mirror(const fixed_light* l, real one_less_cosine, azimuth about)
{
    const real sine = sqrt(one_less_cosine * (R(2.0) - one_less_cosine));
    const real across = sine * about.cosine, aside = sine * about.sine;
    // The frame: r, its derivative by theta_i, and n x l.
    const real outward = one_less_cosine * l->sine - across * l->cosine;
    const mirror_offset o = {outward * l->cos_phi - aside * l->sin_phi,
                             outward * l->sin_phi + aside * l->cos_phi,
                             -(one_less_cosine * l->cosine + across * l->sine)};
    return o;
}

/// With a density of cos theta_o/pi.
static inline mirror_offset about_normal(const fixed_light* l, stream* random)
{
    const real sine2 = uniform_of(next_word(random));
    const azimuth about = even_azimuth(next_word(random));
    const real sine = sqrt(sine2);
    const mirror_offset o = {sine * about.cosine + l->x, sine * about.sine + l->y,
                             sqrt(R(1.0) - sine2) - l->cosine};
    return o;
}

static inline mirror_offset choose_offset(mask_t mask, mirror_offset yes, mirror_offset no)
{
    const mirror_offset o = {choose(mask, yes.x, no.x), choose(mask, yes.y, no.y),
                             choose(mask, yes.z, no.z)};
    return o;
}

#endif

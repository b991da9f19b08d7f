// SPDX-License-Identifier: Apache-2.0
// Random normals of facets, and of those that the light sees. Densities are per solid angle.
#ifndef GONIO_CORE_FACET_NORMALS
#define GONIO_CORE_FACET_NORMALS
#include "core/math.cl"
#include "core/sampling.cl"

/// The slopes whose length is that of a surface of unit roughness.
static inline half_vector stretched_normal(real slope, azimuth about, float alpha_x, float alpha_y)
{
    const half_vector h = {slope * about.cosine * alpha_x, slope * about.sine * alpha_y,
                           (real)(R(1.0))};
    return h;
}

/// D cos theta_h of Beckmann: Walter et al., EGSR 2007, eq. 28.
static inline half_vector beckmann_normal(float alpha_x, float alpha_y, stream* random)
{
    const real slope = sqrt(-log_of_positive(uniform_of(next_word(random))));
    return stretched_normal(slope, even_azimuth(next_word(random)), alpha_x, alpha_y);
}

/// D cos theta_h of GGX: Walter et al., EGSR 2007, eq. 35.
static inline half_vector ggx_normal(float alpha_x, float alpha_y, stream* random)
{
    const real u = uniform_of(next_word(random));
    const real slope = sqrt(u / (R(1.0) - u));
    return stretched_normal(slope, even_azimuth(next_word(random)), alpha_x, alpha_y);
}

/// D G1(l, h) (l.h)/cos_i of V-shaped grooves, from a normal with the density D cos theta_h: this
/// one or the other side of its groove, as much as the light sees of each. Heitz & d'Eon,
/// Importance sampling microfacet-based BSDFs using the distribution of visible normals, CGF 33(4),
/// 2014, algorithm 3.
static inline half_vector side_of_groove(const fixed_light* l, half_vector h, stream* random)
{
    const real tangential = l->x * h.x + l->y * h.y, upright = l->cosine * h.z;
    const real here = max(upright + tangential, (real)(R(0.0)));
    const real there = max(upright - tangential, (real)(R(0.0)));
    const mask_t stays = less(uniform_of(next_word(random)) * (here + there), here);
    const half_vector side = {choose(stays, h.x, -h.x), choose(stays, h.y, -h.y), h.z};
    return side;
}

/// The light as a surface of unit roughness sees it: Heitz, JCGT 3(2), 2014, section 5.3.
typedef struct {
    real x, y, sine, cosine;
} stretched_light;

static inline stretched_light stretch(const fixed_light* l, float alpha_x, float alpha_y)
{
    const real x = (real)(l->x * alpha_x), y = (real)(l->y * alpha_y);
    const real across2 = square(x) + square(y);
    const real scale = R(1.0) / sqrt(across2 + square(l->cosine));
    const stretched_light stretched = {x * scale, y * scale, sqrt(across2) * scale,
                                       l->cosine * scale};
    return stretched;
}

/// D G1(l) (l.h)/cos_i of GGX with Smith's masking (Heitz, JCGT 7(4), 2018): l plus an even
/// direction on the cap of the sphere that l sees, Dupuy & Benyoub, Sampling visible GGX normals
/// with spherical caps, CGF 42(8), 2023.
static inline half_vector ggx_visible_normal(const fixed_light* l, float alpha_x, float alpha_y,
                                             stream* random)
{
    const stretched_light w = stretch(l, alpha_x, alpha_y);
    const real u = uniform_of(next_word(random));
    const azimuth about = even_azimuth(next_word(random));
    const real height = R(1.0) + w.cosine;
    const real upper = (R(1.0) - u) * height;
    // 1 - z and 1 + z of the direction on the cap, without cancellation.
    const real sine = sqrt(u * height * (upper + square(w.sine) / height));
    const half_vector h = {alpha_x * fma(sine, about.cosine, w.x),
                           alpha_y * fma(sine, about.sine, w.y), upper};
    return h;
}

/// The slope s towards the light of a visible normal of unit roughness, whose density is that of
/// (cos + s sin) exp(-s^2). In b = erfc(s) the distribution is b cos + exp(-s^2) sin/sqrt(pi), so
/// that Newton's method needs few steps: Jakob, An improved visible normal sampling routine for the
/// Beckmann distribution, 2014. It is concave: its chord and its parabola at the greatest b, where
/// it is flat, meet u above the root, and from the second step on b rises to it. u: in [2^-24, 1 -
/// 2^-24]. The part of the normals above s is u to 4e-7.
static inline real beckmann_visible_slope(stretched_light w, real u)
{
    const real sine = max(w.sine, (real)(R(1e-30)));
    const real cut = min(w.cosine / sine, (real)(R(12.0)));
    const real cut_exp = exp_of_negative(square(cut));
    const real most = R(2.0) - cut_exp * scaled_erfc(cut);
    const real tilt = sine * R(0.56418958354775629);
    const real all = fma(most, w.cosine, tilt * cut_exp);
    const real target = u * all;
    const real from_top = sqrt((R(1.0) - u) * all * (R(2.2567583341910251) * cut_exp / sine));
    const real least = (real)(R(5.9604644775390625e-8)),
               greatest = min(most, (real)(R(1.9999998807907104)));
    real b = clamp(min(u * most, most - from_top), least, greatest);
    real x = inverse_of_erfc(b);
    for (int step = 0; step < 4; ++step) {
        const real excess = fma(b, w.cosine, tilt * exp_of_negative(square(x))) - target;
        const real rise = max(w.cosine - x * sine, (real)(R(1e-6)));
        b = clamp(b - excess / rise, least, greatest);
        x = inverse_of_erfc(b);
    }
    return -x;
}

/// D G1(l) (l.h)/cos_i of Beckmann with Smith's masking.
static inline half_vector beckmann_visible_normal(const fixed_light* l, float alpha_x,
                                                  float alpha_y, stream* random)
{
    const stretched_light w = stretch(l, alpha_x, alpha_y);
    const real towards = beckmann_visible_slope(w, uniform_of(next_word(random)));
    const real length = sqrt(-log_of_positive(uniform_of(next_word(random))));
    const real aside = length * even_azimuth(next_word(random)).sine;
    const mask_t upright = less(w.sine, (real)(R(1e-30)));
    const real scale = R(1.0) / max(w.sine, (real)(R(1e-30)));
    const real cos_phi = choose(upright, (real)(R(1.0)), w.x * scale);
    const real sin_phi = choose(upright, (real)(R(0.0)), w.y * scale);
    const half_vector h = {alpha_x * (towards * cos_phi - aside * sin_phi),
                           alpha_y * (towards * sin_phi + aside * cos_phi), (real)(R(1.0))};
    return h;
}

#endif

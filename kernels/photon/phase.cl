// SPDX-License-Identifier: Apache-2.0
// Scattering: the polar angle by inversion of the phase function's distribution, an even azimuth,
// and the turn.
#ifndef GONIO_PHOTON_PHASE
#define GONIO_PHOTON_PHASE
#include "core/math.cl"
#include "core/random.cl"
#include "gonio/shared/photon_fields.h"

#ifndef TWO_TERMS
#define TWO_TERMS 0
#endif
#ifndef RAYLEIGH
#define RAYLEIGH 0
#endif
#ifndef TABULATED
#define TABULATED 0
#endif

/// The phase function of the layer that each lane is in.
typedef struct {
    real g_1;
#if TWO_TERMS
    real g_2, weight_1;
#endif
#if RAYLEIGH
    real rayleigh;
#endif
#if TABULATED
    real first_segment, segments;  ///< whole numbers; no segments where there is no table
#endif
} phase_function;

typedef struct {
    real cosine, sine;
} polar;

/// Henyey and Greenstein 1941, inverted: Wang, Jacques and Zheng 1995, eq. 3.22. Multiplied out,
/// 1 - cos and 1 + cos have no differences that cancel, for any g.
static inline polar henyey_greenstein(real g, real u)
{
    const real less_g = R(1.0) - g, more_g = R(1.0) + g;
    const real b = fma(R(2.0) * g, u, less_g);
    const real scale = R(1.0) / square(b);
    const real below_one = square(less_g) * (R(1.0) - u) * (more_g + b) * scale;
    const real above_minus_one = square(more_g) * u * (less_g + b) * scale;
    const polar result = {R(1.0) - below_one, sqrt(below_one * above_minus_one)};
    return result;
}

/// The distribution is (c^3 + 3 c + 4)/8; c = 2 sinh t makes a triple angle of it.
static inline polar rayleigh_angle(real u)
{
    const real x = fma((real)(R(4.0)), u, (real)(R(-2.0)));
    const real power = fabs(x) + sqrt(fma(x, x, (real)(R(1.0))));
    const real root = exp_of_negative(log_of_positive(power) * R(-0.333333333333));
    const real cosine = min(copysign(root - R(1.0) / root, x), (real)(R(1.0)));
    const real sine2 = (R(1.0) - cosine) * (R(1.0) + cosine);
    const polar result = {cosine, sqrt(max(sine2, (real)(R(0.0))))};
    return result;
}

#if TABULATED
/// A density that is linear between cosines. Which segment: Walker's aliases (Vose, IEEE Trans.
/// Software Eng. 17, 1991), one lane after the other; where in it: its distribution inverted.
static inline polar tabulated_angle(const phase_function* phase, real u, word bits,
                                    global const float* segments)
{
    uint words[WIDTH], firsts[WIDTH], counts[WIDTH], low[WIDTH], high[WIDTH], end[WIDTH],
        width[WIDTH];
    store_words(bits, words);
    store_words(word_of(phase->first_segment), firsts);
    store_words(word_of(phase->segments), counts);
    for (uint i = 0; i < WIDTH; ++i) {
        const ulong place = (ulong)words[i] * counts[i];
        global const float* segment = segments + (firsts[i] + (uint)(place >> 32)) * segment_fields;
        const float part = convert_float((uint)place >> 8) * 5.9604644775390625e-8f;
        if (!(part < segment[segment_share]))
            segment = segments + (firsts[i] + (uint)segment[segment_alias]) * segment_fields;
        low[i] = as_uint(segment[segment_low]);
        high[i] = as_uint(segment[segment_high]);
        end[i] = as_uint(segment[segment_end]);
        width[i] = as_uint(segment[segment_width]);
    }
    const real a = as_real(load_words(low)), b = as_real(load_words(high));
    const real root = sqrt(fma(square(b) - square(a), u, square(a)));
    const real part = (a + b) * u / max(a + root, (real)(R(1e-30)));
    const real below_one = fma(max(R(1.0) - part, (real)(R(0.0))), as_real(load_words(width)),
                               as_real(load_words(end)));
    const polar result = {R(1.0) - below_one,
                          sqrt(max(below_one * (R(2.0) - below_one), (real)(R(0.0))))};
    return result;
}
#endif

static inline polar scattering_angle(const phase_function* phase, real u, stream* random,
                                     global const float* segments)
{
#if TWO_TERMS
    const real w = phase->weight_1;
    const mask_t first = less(u, w);
    const real part = choose(first, u / w, (u - w) / (R(1.0) - w));
    polar at = henyey_greenstein(choose(first, phase->g_1, phase->g_2), part);
#else
    polar at = henyey_greenstein(phase->g_1, u);
#endif
#if RAYLEIGH
    const polar other = rayleigh_angle(u);
    const mask_t is_other = less((real)(R(0.5)), phase->rayleigh);
    at.cosine = choose(is_other, other.cosine, at.cosine);
    at.sine = choose(is_other, other.sine, at.sine);
#endif
#if TABULATED
    const polar table = tabulated_angle(phase, u, next_word(random), segments);
    const mask_t has_table = less((real)(R(0.5)), phase->segments);
    at.cosine = choose(has_table, table.cosine, at.cosine);
    at.sine = choose(has_table, table.sine, at.sine);
#endif
    return at;
}

typedef struct {
    real x, y, z;
} direction;

/// Turns a unit vector. The frame around it is that of Duff et al., Building an Orthonormal Basis,
/// Revisited, JCGT 6(1), 2017; one Newton step keeps the length at 1 however often it turns.
static inline direction turned(direction u, polar by, azimuth about)
{
    const real sign = copysign((real)(R(1.0)), u.z);
    const real a = R(-1.0) / (sign + u.z);
    const real b = u.x * u.y * a;
    const real across = by.sine * about.cosine, aside = by.sine * about.sine;
    const real signed_across = sign * across;
    // The frame's vectors are (1 + sign a x^2, sign b, -sign x) and (b, sign + a y^2, -y).
    const real ax = a * u.x, ay = a * u.y;
    direction v;
    v.x = fma(signed_across * ax, u.x, fma(aside, b, fma(by.cosine, u.x, across)));
    v.y = fma(signed_across, b, fma(aside, fma(ay, u.y, sign), by.cosine * u.y));
    v.z = fma(by.cosine, u.z, -fma(signed_across, u.x, aside * u.y));
    const real length2 = fma(v.x, v.x, fma(v.y, v.y, square(v.z)));
    const real scale = fma((real)(R(-0.5)), length2, (real)(R(1.5)));
    v.x *= scale;
    v.y *= scale;
    v.z *= scale;
    return v;
}

#endif

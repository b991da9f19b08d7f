// SPDX-License-Identifier: Apache-2.0
// Random numbers of a photon or of a sample, of the engine's stream or of one that a program
// includes before it.
#ifndef GONIO_CORE_RANDOM
#define GONIO_CORE_RANDOM
#include "core/streams/xoshiro.cl"

#ifndef NEXT_THREE
/// What a step of a photon takes. Streams that make several words at once have their own.
static inline void next_three(stream* s, word* first, word* second, word* third)
{
    *first = next_word(s);
    *second = next_word(s);
    *third = next_word(s);
}
#endif

/// In (0, 1), from the upper 24 bits: an odd multiple of 2^-24, exact, and so is 1 minus it.
static inline real uniform_of(word bits)
{
    return real_of((bits >> 8) | 1) * R(5.9604644775390625e-8);
}

typedef struct {
    real cosine, sine;
} azimuth;

/// An even angle: the upper bits choose one within 45 degrees of an axis, the lowest two the axis.
/// The polynomials' errors are below 1e-7.
static inline azimuth even_azimuth(word bits)
{
    const real angle = (uniform_of(bits) - R(0.5)) * (R(0.5) * PI);
    const real z = square(angle);
    real s = (real)(R(-1.9515295891e-4));
    s = fma(s, z, (real)(R(8.3321608736e-3)));
    s = fma(s, z, (real)(R(-1.6666654611e-1)));
    s = fma(s * z, angle, angle);
    real c = (real)(R(2.443315711809948e-5));
    c = fma(c, z, (real)(R(-1.388731625493765e-3)));
    c = fma(c, z, (real)(R(4.166664568298827e-2)));
    c = fma(c * z, z, fma((real)(R(-0.5)), z, (real)(R(1.0))));
    const mask_t swapped = -bits_of(bits & 1), sign = bits_of((bits & 2) << 30);
    const azimuth result = {as_real(bits_of(choose(swapped, s, c)) ^ sign),
                            as_real(bits_of(choose(swapped, c, s)) ^ sign)};
    return result;
}

#endif

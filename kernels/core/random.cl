// SPDX-License-Identifier: Apache-2.0
// Random numbers of a photon or of a sample. They depend on nothing but the seed and its number.
#ifndef GONIO_CORE_RANDOM
#define GONIO_CORE_RANDOM
#include "core/word.cl"

/// The state of xoshiro128++ 1.0: Blackman and Vigna, Scrambled Linear Pseudorandom Number
/// Generators, ACM TOMS 47(4), 2021.
typedef struct {
    word a, b, c, d;
} stream;

static inline word high_word(word a, uint b)
{
    // Not mul_hi(), which PoCL compiles badly.
    return word_of((long_of(a) * (ulong)b) >> 32);
}

/// Philox4x32-10 of the counter (low, high, 0, 0) and the key `seed`: Salmon et al., Parallel
/// Random Numbers: As Easy as 1, 2, 3, SC 2011. Only one state in 2^128 is one that xoshiro cannot
/// have.
static inline stream seeded_stream(word low, word high, ulong seed)
{
    stream s = {low, high, (word)(0), (word)(0)};
    uint key_0 = (uint)seed, key_1 = (uint)(seed >> 32);
    for (int round = 0; round < 10; ++round) {
        const word high_0 = high_word(s.a, 0xD2511F53u), low_0 = s.a * 0xD2511F53u;
        const word high_1 = high_word(s.c, 0xCD9E8D57u), low_1 = s.c * 0xCD9E8D57u;
        const stream next = {high_1 ^ s.b ^ key_0, low_1, high_0 ^ s.d ^ key_1, low_0};
        s = next;
        key_0 += 0x9E3779B9u;
        key_1 += 0xBB67AE85u;
    }
    return s;
}

/// The stream of photon or sample first + offset.
static inline stream numbered_stream(ulong first, word offset, ulong seed)
{
    const word low = (uint)first + offset;
    const word carry = choose_word(smaller(low, offset), (word)(1), (word)(0));
    return seeded_stream(low, (uint)(first >> 32) + carry, seed);
}

static inline word next_word(stream* s)
{
    const word result = rotate(s->a + s->d, (word)(7)) + s->a;
    const word shifted = s->b << 9;
    s->c ^= s->a;
    s->d ^= s->b;
    s->b ^= s->c;
    s->a ^= s->d;
    s->c ^= shifted;
    s->d = rotate(s->d, (word)(11));
    return result;
}

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

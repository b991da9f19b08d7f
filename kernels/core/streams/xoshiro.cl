// SPDX-License-Identifier: Apache-2.0
// The engine's random numbers: xoshiro128++ 1.0, Blackman and Vigna, Scrambled Linear Pseudorandom
// Number Generators, ACM TOMS 47(4), 2021, seeded by a block of Philox once a photon. A block for
// every step instead would take photons 1.4 times as long (gonio bench device-generators).
#ifndef GONIO_CORE_STREAM
#define GONIO_CORE_STREAM
#include "core/philox.cl"

typedef four_words stream;
#define choose_stream choose_words

/// The stream of photon or sample first + offset. Only one state in 2^128 is one that xoshiro
/// cannot have.
static inline stream numbered_stream(ulong first, word offset, ulong seed)
{
    return philox(numbered(first, offset), seed, 10);
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

#endif

// SPDX-License-Identifier: Apache-2.0
// The engine's random numbers: xoshiro128++ 1.0, Blackman and Vigna, Scrambled Linear Pseudorandom
// Number Generators, ACM TOMS 47(4), 2021, seeded by a block of Philox once a photon: of 2^128
// states it may give one that xoshiro cannot have. A block for every step instead would take
// photons 1.4 times as long (gonio bench device-generators).
#ifndef GONIO_CORE_STREAM
#define GONIO_CORE_STREAM
#include "core/streams/seeded.cl"

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

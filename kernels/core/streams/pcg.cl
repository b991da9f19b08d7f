// SPDX-License-Identifier: Apache-2.0
// To be compared with the engine's random numbers: PCG-XSH-RR 64/32, O'Neill, PCG, Harvey Mudd
// College HMC-CS-2014-0905, 2014, seeded by Philox.
#ifndef GONIO_CORE_STREAM
#define GONIO_CORE_STREAM
#include "core/streams/seeded.cl"

/// The state is in a, its lower half, and b.
static inline word next_word(stream* s)
{
    const long_word state = long_of(s->b) << 32 | long_of(s->a);
    const long_word next = state * 6364136223846793005UL + 1442695040888963407UL;
    s->a = word_of(next);
    s->b = word_of(next >> 32);
    return rotate(word_of((state >> 18 ^ state) >> 27), -word_of(state >> 59));
}

#endif

// SPDX-License-Identifier: Apache-2.0
// To be compared with the engine's random numbers: multiply with carry, as GPU codes of photons use
// it, Alerstam, Svensson, Andersson-Engels, J. Biomed. Opt. 13, 060504, 2008, seeded by Philox.
#ifndef GONIO_CORE_STREAM
#define GONIO_CORE_STREAM
#include "core/streams/seeded.cl"

/// The state is in a, its lower half, and b.
static inline word next_word(stream* s)
{
    const long_word next = long_of(s->a) * 4294967118UL + long_of(s->b);
    s->a = word_of(next);
    s->b = word_of(next >> 32);
    return s->a;
}

#endif

// SPDX-License-Identifier: Apache-2.0
// A stream that a block of Philox seeds, once a photon or sample.
#ifndef GONIO_CORE_SEEDED
#define GONIO_CORE_SEEDED
#include "core/philox.cl"

typedef four_words stream;
#define choose_stream choose_words

/// The stream of photon or sample first + offset.
static inline stream numbered_stream(ulong first, word offset, ulong seed)
{
    return philox(numbered(first, offset), seed, 10);
}

/// Of a lane that has no photon yet. A second numbered_stream() in its place was not inlined any
/// more, neither of them, and photons with A(r, z) took 1.5 times as long.
static inline stream no_stream(void)
{
    const stream none = {(word)(0), (word)(0), (word)(0), (word)(0)};
    return none;
}

#endif

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

#endif

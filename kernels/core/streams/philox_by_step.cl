// SPDX-License-Identifier: Apache-2.0
// To be compared with the engine's random numbers: a block of Philox for every step of a photon.
#ifndef GONIO_CORE_STREAM
#define GONIO_CORE_STREAM
#include "core/philox.cl"

#ifndef STEP_ROUNDS
#define STEP_ROUNDS 10
#endif
#define NEXT_THREE

typedef struct {
    four_words counter;  ///< c counts the steps
    ulong seed;
} stream;

/// The stream of photon or sample first + offset.
static inline stream numbered_stream(ulong first, word offset, ulong seed)
{
    const stream s = {numbered(first, offset), seed};
    return s;
}

/// Of a lane that has no photon yet.
static inline stream no_stream(void)
{
    const stream none = {{(word)(0), (word)(0), (word)(0), (word)(0)}, 0};
    return none;
}

static inline stream choose_stream(mask_t mask, stream yes, stream no)
{
    const stream s = {choose_words(mask, yes.counter, no.counter), yes.seed};
    return s;
}

static inline void next_three(stream* s, word* first, word* second, word* third)
{
    const four_words block = philox(s->counter, s->seed, STEP_ROUNDS);
    s->counter.c += 1;
    *first = block.a;
    *second = block.b;
    *third = block.c;
}

static inline word next_word(stream* s)
{
    word first, second, third;
    next_three(s, &first, &second, &third);
    return first;
}

#endif

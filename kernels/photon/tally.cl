// SPDX-License-Identifier: Apache-2.0
// Counts weight: 64-bit sums, one set for each work-item, or one for all of them that is added to
// atomically.
#ifndef GONIO_PHOTON_TALLY
#define GONIO_PHOTON_TALLY
#include "core/math.cl"
#include "core/word.cl"
#include "gonio/shared/photon_fields.h"

#ifndef SHARED_TALLIES
#define SHARED_TALLIES 0
#endif

#define FOR_LANES(i) for (uint i = 0; i < WIDTH; ++i)

/// Adds to a sum. 64-bit atomics are an extension: the halves carry.
static inline void add_weight(global ulong* tallies, uint place, ulong amount)
{
#if SHARED_TALLIES
    if (amount == 0) return;
    global uint* halves = (global uint*)(tallies + place);
    const uint low = (uint)amount, before = atomic_add(halves, low);
    const uint high = (uint)(amount >> 32) + (before + low < before ? 1 : 0);
    if (high != 0) atomic_add(halves + 1, high);
#else
    tallies[place] += amount;
#endif
}

/// Adds what each lane has to the sum first + its place. Lanes that have nothing add 0 to the first
/// one: where nothing is shared that takes less time than a branch, which nobody can predict.
static inline void add_weights(global ulong* tallies, uint first, word places, word amounts)
{
    uint at[WIDTH], weights[WIDTH];
    store_words(choose_word(smaller((word)(0), amounts), places, (word)(0)), at);
    store_words(amounts, weights);
    FOR_LANES(i) add_weight(tallies, first + at[i], weights[i]);
}

/// Even bins from 0 on, and one more for what lies beyond.
static inline word bin_of(real value, float bins_per_unit, uint count)
{
    return word_of(min(value * bins_per_unit, (real)((float)count)));
}

/// Bins of the distance from the axis.
static inline word radius_bin(real x, real y, float bins_per_unit, uint count)
{
    return bin_of(sqrt(fma(x, x, y * y)), bins_per_unit, count);
}

/// Even bins of the azimuth, 0 to 180 degrees on either side of +x.
static inline word azimuth_bin(real x, real y, uint count)
{
    const real angle = angle_of(fabs(y), fabs(x));
    const real part = choose(less(x, (real)(R(0.0))), PI - angle, angle) / PI;
    return word_of(min(part * (float)count, (real)((float)(count - 1))));
}

/// Even bins of the angle to the normal; sine and cosine are at least 0.
static inline word angle_bin(real sine, real cosine, uint count)
{
    const real part = angle_of(sine, cosine) * (R(2.0) / PI);
    return word_of(min(part * (float)count, (real)((float)(count - 1))));
}

#endif

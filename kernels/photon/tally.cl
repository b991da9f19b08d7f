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

/// Adds to a sum. 64-bit atomics are an extension: the halves carry.
static inline void add_weight(global ulong* tallies, uint place, uint amount)
{
#if SHARED_TALLIES
    global uint* halves = (global uint*)(tallies + place);
    const uint before = atomic_add(halves, amount);
    if (before + amount < before) atomic_inc(halves + 1);
#else
    tallies[place] += amount;
#endif
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

// SPDX-License-Identifier: Apache-2.0
// How the errors of photons fall with time: those that they have, and those that they tell.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gonio/photons.hpp"
#include "timings/sections.hpp"

namespace gonio {

/// Numbers that photons find, one or the bins of a tally, in the same order as what is right.
struct PhotonNumbers {
    std::string name;
    std::vector<double> right;  ///< parts of the light; empty where only photons tell
    std::function<std::vector<Fraction>(const PhotonResult&)> of;
};

/// Adds points of the benchmarks' skin, of 2^12 photons to 2^most_power, several seeds each: the
/// true errors where it is known what is right, and the standard errors. Both are roots of mean
/// squares over numbers and seeds, over that of the numbers.
void add_photons(BenchPlot& plot, const BenchRun& run, const PhotonTallies& tallies,
                 const std::vector<PhotonNumbers>& all, int most_power);

/// Adds the line on which errors fall with the root of the time, through the last point, over the
/// times of its series.
void add_slope(BenchPlot& plot);

}  // namespace gonio

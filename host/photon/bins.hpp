// SPDX-License-Identifier: Apache-2.0
// Which tallies a quantity needs, and what its bins are divided by.
#pragma once

#include <cstdint>
#include <vector>

#include "gonio/photons.hpp"
#include "gonio/quantity.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// For the axes of a table, even bins from 0 on.
PhotonTallies tallies_of(const Quantity& quantity, const std::vector<Axis>& axes);

/// The bins of the quantity's tally without those of the overflow, per cm, cm^2, cm^3, sr and ps as
/// its unit says, row-major over the axes; for a number the parts of the budget; for a BRDF the
/// cells of one theta_i.
std::vector<Fraction> densities(const PhotonResult& result, const Quantity& quantity,
                                const PhotonTallies& tallies, const std::vector<Axis>& axes);

/// Per area of rings of one width, from the innermost on.
std::vector<Fraction> ring_densities(const std::vector<Fraction>& rings, double width);

/// The largest error over the largest value; 0 where all values are.
double largest_error(const std::vector<Fraction>& values);
/// The root of the mean square of their relative errors; infinite where a value is 0.
double mean_relative_error(const std::vector<Fraction>& values);

/// The batch for a given number of photons: a power of two, at least 64 of them.
std::uint64_t batch_of(std::uint64_t photons);

/// The batch that begins with a photon: a 64th of the number that is given, else about a 32nd of
/// all before it.
std::uint64_t batch_from(std::uint64_t photon, std::uint64_t most);
inline constexpr std::uint64_t least_batches = 32;  ///< before an error is believed
inline constexpr std::uint64_t largest_batch = std::uint64_t{1} << 30;
inline constexpr std::uint64_t no_limit = UINT64_MAX;  ///< of photons

/// What lies beyond the last bins, of all the incident light.
double overflow(const PhotonResult& result, const PhotonTallies& tallies);

/// Solid angle between two angles to the normal that are k and k + 1 n-ths of 90 degrees, sr.
double solid_angle(std::size_t k, std::size_t n);
/// Area between the circles of radius k and k + 1 widths.
double ring_area(std::size_t k, double width);

}  // namespace gonio

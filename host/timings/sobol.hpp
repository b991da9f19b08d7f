// SPDX-License-Identifier: Apache-2.0
// Sobol's sequence, and its scrambling after Owen.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gonio {

inline constexpr std::size_t sobol_dimensions = 8;

/// A coordinate of a point, times 2^32: Sobol 1967 with the direction numbers of Joe and Kuo,
/// Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci. Comput.
/// 30(5), 2008.
std::uint32_t sobol(std::uint32_t point, std::size_t dimension);

/// A coordinate with each of its bits flipped by chance that hangs on the higher bits and the key:
/// Owen 1995, by the hash of Laine and Karras as in Burley, Practical hash-based Owen scrambling,
/// JCGT 9(4), 2020. Nets stay nets.
std::uint32_t owen_scrambled(std::uint32_t coordinate, std::uint32_t key);

}  // namespace gonio

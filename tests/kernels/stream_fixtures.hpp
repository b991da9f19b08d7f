// SPDX-License-Identifier: Apache-2.0
// Words of the kernels' random numbers, and Philox to check them by.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gonio::test {

using SixWords = std::array<std::uint32_t, 6>;

/// Six words of each photon's stream, that `body` stores in lanes[0] to lanes[5]; preamble:
/// includes another stream than the engine's.
std::vector<SixWords> drawn(const std::string& preamble, const std::string& body,
                            std::uint64_t first, std::uint32_t count, std::uint64_t seed,
                            unsigned width);

/// Salmon et al., SC 2011, in 64-bit arithmetic.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key, int rounds = 10);

}  // namespace gonio::test

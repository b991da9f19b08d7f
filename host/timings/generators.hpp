// SPDX-License-Identifier: Apache-2.0
// Generators of random numbers to compare, good and bad ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace gonio {

/// A source of numbers in (0, 1).
struct Numbers {
    std::function<double()> uniform;
    /// What comes next are those of a photon; empty where that is the same to all of them.
    std::function<void(std::size_t photon)> begin = {};
};

struct Generator {
    std::string_view name;
    /// So many consecutive photons are a batch, independent of the others.
    std::function<Numbers(std::uint32_t seed, std::size_t batch)> make;
};

const std::vector<Generator>& generators();

}  // namespace gonio

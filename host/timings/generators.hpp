// SPDX-License-Identifier: Apache-2.0
// Generators of random numbers to compare, good and bad ones.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace gonio {

struct Generator {
    std::string_view name;
    /// Makes a source of numbers in (0, 1).
    std::function<std::function<double()>(std::uint32_t seed)> make;
};

const std::vector<Generator>& generators();

}  // namespace gonio

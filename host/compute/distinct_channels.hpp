// SPDX-License-Identifier: Apache-2.0
// Channels whose numbers all agree are one, and colours that are grey.
#pragma once

#include <cstddef>
#include <vector>

#include "gonio/material.hpp"

namespace gonio {

struct DistinctChannels {
    Material material;            ///< with one channel for each set of numbers
    std::vector<std::size_t> of;  ///< which of them each channel of the given material is
};

DistinctChannels distinct_channels(const Material& material);

/// Every channel as it is.
DistinctChannels all_channels(const Material& material);

/// Is a list of numbers, one or one for each channel, this one in all of them?
bool all_are(const std::vector<double>& numbers, double number);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// gonio verify --extreme.
#pragma once

#include <string>
#include <vector>

#include "gonio/device.hpp"

namespace gonio {

/// Prints the table of hard spots of these models; of all of them, and that of hard media, where
/// none is named. Throws UsageError for models that have no hard spots, and CheckFailed where a
/// bound is broken.
void verify_extremes(const Device& device, const std::vector<std::string>& models, bool json);

}  // namespace gonio

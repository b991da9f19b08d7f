// SPDX-License-Identifier: Apache-2.0
// gonio verify --extreme.
#pragma once

#include "gonio/device.hpp"

namespace gonio {

/// Prints the table of hard spots and that of hard media. Throws CheckFailed where a bound is
/// broken.
void verify_extremes(const Device& device, bool json);

}  // namespace gonio

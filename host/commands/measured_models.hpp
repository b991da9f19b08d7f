// SPDX-License-Identifier: Apache-2.0
// gonio models --measure: accuracy, speed and the largest albedo of models on a device.
#pragma once

#include <vector>

#include "gonio/device.hpp"
#include "gonio/model.hpp"

namespace gonio {

/// Measures one after the other with a line of progress, and prints a table or JSON.
void print_measured(const Device& device, const std::vector<const Model*>& models, bool json);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The roof of every table: how fast the device writes floats when it computes nothing.
#pragma once

#include <cstddef>

#include "gonio/device.hpp"

namespace gonio {

/// Floats per second that kernel `store` writes into a buffer of 64 MiB: the median of a few runs,
/// measured once per device.
double stored_values_per_second(const Device& device);

}  // namespace gonio

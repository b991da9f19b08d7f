// SPDX-License-Identifier: Apache-2.0
// A part of a device, to see how work grows with compute units.
#pragma once

#include <optional>

#include "gonio/device.hpp"

namespace gonio {

/// The device with that many of its compute units, at its width; nothing where it cannot be parted.
std::optional<Device> part_of(const Device& device, unsigned compute_units);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// How a grid is cut into tiles, of which two are in memory.
#pragma once

#include <cstddef>

#include "gonio/compute.hpp"

namespace gonio {

struct Tiling {
    std::size_t rows = 0;   ///< in a tile, but for the last
    std::size_t tiles = 0;  ///< of one material
    std::size_t bytes = 0;  ///< of such a tile, all channels
};

/// Within the bound and the device's limits. A reciprocal table needs whole squares of rows. Throws
/// UsageError where not even those fit into a buffer of the device.
Tiling tiling(const DeviceInfo& device, const Grid& grid, std::size_t channels, bool reciprocal,
              std::size_t tile_bytes = ComputeOptions{}.tile_bytes);

}  // namespace gonio

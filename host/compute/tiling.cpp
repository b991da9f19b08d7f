// SPDX-License-Identifier: Apache-2.0
// How a grid is cut into tiles.
#include "compute/tiling.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gonio/errors.hpp"

namespace gonio {

Tiling tiling(const DeviceInfo& device, const Grid& grid, std::size_t channels, bool reciprocal,
              std::size_t tile_bytes)
{
    std::size_t rows = 1;
    for (std::size_t k = 0; k + 1 < grid.axes.size(); ++k) rows *= grid.axes[k].values.size();
    const std::size_t row_bytes = channels * grid.axes.back().values.size() * sizeof(float);
    const std::size_t granule = reciprocal ? grid.axes[1].values.size() : 1;
    if (row_bytes * granule > device.largest_buffer_bytes)
        throw UsageError(
            fmt::format("a row of {} bytes is larger than the device's largest buffer, {} bytes",
                        row_bytes * granule, device.largest_buffer_bytes));
    const std::size_t bound =
        std::min<std::size_t>({tile_bytes, device.largest_buffer_bytes, device.global_bytes / 4});
    const std::size_t granules = std::max<std::size_t>(1, bound / (row_bytes * granule));
    const std::size_t of_tile = std::min(rows, granules * granule);
    return {of_tile, (rows + of_tile - 1) / of_tile, of_tile * row_bytes};
}

}  // namespace gonio

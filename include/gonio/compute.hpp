// SPDX-License-Identifier: Apache-2.0
// Evaluates materials on a device: dense grids in tiles, and lists of points.
#pragma once

#include <functional>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/grid.hpp"
#include "gonio/material.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// Receives rows in ascending order, while the device computes the next ones. The planes are valid
/// during the call.
using RowSink = std::function<void(const Rows<float>&)>;

struct ComputeOptions {
    /// Leave out what follows from the rest, or is nothing: mirror images, reciprocal halves, lobes
    /// that reflect nothing, channels and colours that agree, Fresnel factors of 1.
    bool leave_out = true;
    std::size_t tile_bytes = std::size_t{64} << 20;  ///< upper bound of one tile; two are in flight
};

/// What happened, for reports. Nothing of it is written into tables.
struct ComputeReport {
    double kernel_seconds = 0;  ///< by the device's clock
    double build_seconds = 0;
    std::size_t tiles = 0;
    unsigned width = 1;
    bool mirrored = false, reciprocal = false;
};

/// Values of all cells, channel by channel. Rows with a direction at exactly 90 degrees hold the
/// model's limit there if it is finite, else 0. Throws UsageError for an anisotropic material on a
/// grid that has no tangent frame, Interrupted after Ctrl-C.
ComputeReport compute_grid(const Device& device, const Material& material, Measure measure,
                           const Grid& grid, const RowSink& sink,
                           const ComputeOptions& options = {});

/// values[channel][point]
std::vector<std::vector<float>> compute_points(const Device& device, const Material& material,
                                               Measure measure,
                                               const std::vector<DirectionPair>& points);

/// The whole of a grid in memory.
Table compute_table(const Device& device, const Material& material, Measure measure,
                    const Grid& grid);

}  // namespace gonio

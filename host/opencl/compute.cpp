// SPDX-License-Identifier: Apache-2.0
// Runs a material over a grid in tiles, the next one on the device while the sink has the last; and
// over lists of points.
#include "gonio/compute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>

#include "compute/distinct_channels.hpp"
#include "compute/horizon.hpp"
#include "compute/idle_lobes.hpp"
#include "compute/symmetry.hpp"
#include "compute/tiling.hpp"
#include "gonio/errors.hpp"
#include "opencl/grid_kernel.hpp"

namespace gonio {
namespace {

void check_frame(const Material& material, const Grid& grid)
{
    if (grid.kind != GridKind::anisotropic && !material.isotropic())
        throw UsageError(fmt::format(
            "material `{}` is anisotropic and needs a grid with a tangent frame: kind = "
            "\"anisotropic\", or the same roughness along x and y",
            material.name));
}

/// of: which of the planes each channel is.
std::vector<const float*> planes_of(const float* values, const std::vector<std::size_t>& of,
                                    std::size_t plane)
{
    std::vector<const float*> planes;
    for (const std::size_t distinct : of) planes.push_back(values + distinct * plane);
    return planes;
}

}  // namespace

ComputeReport compute_grid(const Device& handle, const Material& given, Measure measure,
                           const Grid& grid, const RowSink& sink, const ComputeOptions& options)
try {
    const DistinctChannels distinct =
        options.leave_out ? distinct_channels(without_idle_lobes(given)) : all_channels(given);
    const Material& material = distinct.material;
    check_frame(material, grid);
    Device::State& device = handle.state();
    const DirectionTables tables = direction_tables(grid, !material.isotropic());
    const std::size_t channels = material.channels(), row_size = channels * tables.length;
    const bool reciprocal = options.leave_out && is_reciprocal(material, measure, grid);
    const bool mirrored = options.leave_out && is_mirrored(material, grid);
    GridKernel kernel(device, material, tables,
                      {"", measure, mirrored, reciprocal, handle.width(), options.leave_out});

    const std::size_t tile =
        tiling(device.info, grid, channels, reciprocal, options.tile_bytes).rows;
    ComputeReport report{0,         kernel.build_seconds(), 0, kernel.program().width, mirrored,
                         reciprocal};
    const Reference reference = make_reference(material, measure);
    const bool horizon = touches_horizon(grid);
    const cl_map_flags access = horizon ? CL_MAP_READ | CL_MAP_WRITE : CL_MAP_READ;

    std::deque<OutputBuffer> buffers;  // they do not move
    for (std::size_t k = 0; k < (tile < tables.rows ? 2 : 1); ++k)
        buffers.emplace_back(device, tile * row_size);
    std::array<cl::Event, 2> events;
    const auto enqueue = [&](std::size_t first) {
        const std::size_t slot = first / tile % buffers.size(),
                          count = std::min(tile, tables.rows - first);
        events[slot] = kernel.enqueue(buffers[slot], first, count);
        buffers[slot].map(count * row_size, access);
    };
    enqueue(0);
    for (std::size_t first = 0; first < tables.rows; first += tile) {
        if (first + tile < tables.rows) enqueue(first + tile);
        const std::size_t slot = first / tile % buffers.size(),
                          count = std::min(tile, tables.rows - first);
        float* values = buffers[slot].wait();
        report.kernel_seconds += seconds_of(events[slot]);
        ++report.tiles;
        if (horizon) clear_poles(reference, grid, channels, first, count, values);
        sink({first, count, planes_of(values, distinct.of, count * tables.length)});
        buffers[slot].unmap();
    }
    for (OutputBuffer& buffer : buffers) buffer.check_canary();
    return report;
} catch (const cl::Error& error) {
    throw RunError(fmt::format("{} failed: {}", handle.info().name, error_text(error)));
}

std::vector<std::vector<float>> compute_points(const Device& handle, const Material& material,
                                               Measure measure,
                                               const std::vector<DirectionPair>& points)
try {
    if (points.empty()) return std::vector<std::vector<float>>(material.channels());
    Device::State& device = handle.state();
    const std::size_t channels = material.channels();
    GridKernel kernel(device, material, direction_tables(points),
                      {"", measure, false, false, handle.width()});
    OutputBuffer out(device, channels * points.size());
    kernel.enqueue(out, 0, 1);
    out.map(channels * points.size());
    const float* values = out.wait();
    std::vector<std::vector<float>> result;
    for (std::size_t c = 0; c < channels; ++c)
        result.emplace_back(values + c * points.size(), values + (c + 1) * points.size());
    out.unmap();
    out.check_canary();
    const Reference reference = make_reference(material, measure);
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k].theta_i == 90 || points[k].theta_o == 90)
            for (std::size_t c = 0; c < channels; ++c)
                if (!has_limit_on_horizon(reference, points[k], c)) result[c][k] = 0;
    return result;
} catch (const cl::Error& error) {
    throw RunError(fmt::format("{} failed: {}", handle.info().name, error_text(error)));
}

Table compute_table(const Device& device, const Material& material, Measure measure,
                    const Grid& grid)
{
    Table table;
    table.header.quantity = measure == Measure::brdf_cosine ? "brdf_cosine" : "brdf";
    table.header.unit = "1/sr";
    table.header.axes = grid.axes;
    table.header.channels = material.channel_names();
    table.values.resize(table.header.channels.size());
    compute_grid(device, material, measure, grid, [&](const Rows<float>& rows) {
        for (std::size_t c = 0; c < table.values.size(); ++c)
            table.values[c].insert(table.values[c].end(), rows.planes[c],
                                   rows.planes[c] + rows.count * table.header.row_length());
    });
    return table;
}

}  // namespace gonio

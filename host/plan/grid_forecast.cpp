// SPDX-License-Identifier: Apache-2.0
// What a table of a BRDF will cost: the device is fast, so that it is to check it and to write it.
#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "opencl/store_rate.hpp"
#include "output/half_rounding.hpp"
#include "plan/forecast_parts.hpp"
#include "plan/trial.hpp"
#include "verify/accuracy.hpp"

namespace gonio {
namespace {

/// Between the cheapest and the dearest models of the catalogue, of the values that a device can
/// store.
constexpr double part_of_store_rate = 0.5;
constexpr std::size_t pilot_values = 1 << 14;
constexpr double largest_half = 65504;  // what it takes to write is the same of larger ones

/// Rows from the middle of a table, by the reference, and the seconds that they took.
struct Slice {
    std::size_t rows = 0, length = 0;
    std::vector<std::vector<float>> planes;
    double seconds = 0;

    Slice(const Grid& grid, const Reference& reference, std::size_t channels, std::size_t all_rows)
        : length(grid.axes.back().values.size()), planes(channels)
    {
        const GridVectors vectors(grid);
        rows = std::clamp<std::size_t>(pilot_values / (length * channels), 1, all_rows);
        const std::size_t first = (all_rows - rows) / 2;
        const Stopwatch since;
        for (std::size_t k = 0; k < rows * length; ++k) {
            const auto [l, v] = vectors.at(first + k / length, k % length);
            const bool lit = l.z > 0 && v.z > 0;
            for (std::size_t c = 0; c < channels; ++c)
                planes[c].push_back(
                    lit ? static_cast<float>(std::min(reference(l, v, c), largest_half)) : 0);
        }
        seconds = since.seconds();
    }
};

/// A file's: for its values, and for the rest.
struct WriteSeconds {
    double values = 0, end = 0;
};

WriteSeconds write(const Job& job, const Slice& slice)
{
    // A MERL file has one size only; numpy's are written as fast.
    const std::string format = job.format == "merl" ? "npy" : job.format;
    TableHeader header = job.header;
    header.sweep_axes = 0;
    header.axes = {make_axis("theta_o", 0, 90, slice.rows, Samples::centre),
                   make_axis("delta_phi", 0, 360, slice.length, Samples::centre)};
    Rows<float> rows{0, slice.rows, {}};
    for (const auto& plane : slice.planes) rows.planes.push_back(plane.data());
    const ScratchFolder scratch;
    const auto writer = make_writer(scratch.path() / "slice", format, header, job.write);
    const Stopwatch since;
    writer->write(rows);
    const double values = since.seconds();
    writer->finish();
    return {values, since.seconds() - values};
}

}  // namespace

Forecast grid_forecast(const Device& device, const Job& job)
{
    const Material& material = job.materials[job.materials.size() / 2];
    Forecast result{.error = accuracy_bound(material),
                    .error_of = "each value from 1e-6 of the largest on"};
    if (stores_half(job)) {
        result.error += half_rounding::relative;
        result.error_of = fmt::format("each value from {:.1e} on", half_rounding::least_normal);
    }
    if (job.fit) {
        result.seconds = *job.seconds;
        return result;
    }
    const std::size_t channels = job.header.channels.size();
    const std::size_t points = job.materials.size(), rows = job.header.rows() / points;
    const Slice slice(job.grid, make_reference(material, job.measure), channels, rows);
    const WriteSeconds writing = write(job, slice);
    const auto values = static_cast<double>(job.header.cells() * channels);
    const double slices = values / static_cast<double>(slice.rows * slice.length * channels);
    const auto compared = static_cast<double>(
        points * AccuracyCheck::compared(job.header.cells() * channels / points));
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    result.seconds = values / (part_of_store_rate * stored_values_per_second(device)) +
                     slice.seconds * slices * compared / values / processors +
                     writing.values * slices + writing.end;
    return result;
}

}  // namespace gonio

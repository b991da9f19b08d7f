// SPDX-License-Identifier: Apache-2.0
// How the rate grows with the size of a launch: where its fixed cost no longer shows.
#include <fmt/format.h>

#include "opencl/grid_kernel.hpp"
#include "opencl/photon_kernel.hpp"
#include "stopwatch.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr std::size_t thetas = 64, azimuths = 1024;
constexpr std::uint32_t most_photons = 1 << 16;

/// Of one launch, of as many as fit into a hundredth of a second.
double seconds_each(const std::function<void()>& launch)
{
    constexpr double enough = 0.01;
    const Stopwatch since;
    for (int count = 1;; ++count) {
        launch();
        if (const double all = since.seconds(); all > enough) return all / count;
    }
}

}  // namespace

BenchPlot bench_work_size(const BenchRun& run)
{
    BenchPlot plot{"work-size", "Over the size of a launch",
                   "One launch after the other, each waited for, by the wall's clock: rows of a "
                   "table of GGX, 1024 values each, and photons in skin, on all units of the "
                   "device. Where a line is level, launching costs nothing any more.",
                   "values or photons in a launch", "of them per second"};
    run.step("work-size");
    const DirectionTables tables =
        direction_tables(isotropic_grid(thetas, thetas, azimuths, Samples::centre, 180), false);
    GridKernel grid(run.device.state(), {"ggx", {default_lobe("ggx")}}, tables,
                    {"", Measure::brdf, false, false, run.device.width()});
    const OutputBuffer out(run.device.state(), tables.rows * azimuths);
    PhotonKernel photons(run.device, photon_program(benchmark_skin(), {}), 1);
    std::vector<std::function<double()>> runs;
    const auto add = [&](const char* series, std::size_t size,
                         const std::function<void()>& launch) {
        launch();
        plot.points.push_back(
            {series, fmt::format("{} in a launch", size), exactly(double(size)), {}});
        runs.emplace_back([launch] { return seconds_each(launch); });
    };
    for (std::size_t rows = 1; rows <= tables.rows; rows *= 4)
        add("values of a table", rows * azimuths, [&, rows] { grid.enqueue(out, 0, rows).wait(); });
    for (std::uint32_t count = 16; count <= most_photons; count *= 4)
        add("photons", count, [&, count] { photons.run(0, count); });
    const std::vector<Quartiles> seconds = interleaved(runs, run.rounds());
    for (std::size_t k = 0; k < seconds.size(); ++k) {
        BenchPoint& point = plot.points[k];
        point.y = rate_of(point.x.median, seconds[k]);
    }
    return plot;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What it takes until a program runs: building, the first launch, and the same again.
#include <fmt/format.h>

#include <array>
#include <chrono>

#include "opencl/grid_kernel.hpp"
#include "opencl/photon_kernel.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr std::array stages{"build", "first launch", "second launch", "cached build",
                            "launch after it"};

/// Stages in seconds, of several rounds.
using Stages = std::array<std::vector<double>, stages.size()>;

PhotonProgram skin_program(bool absorbed)
{
    PhotonRequest request;
    if (absorbed) {
        request.tallies.absorbed = true;
        request.tallies.depths = request.tallies.absorbed_radii = 50;
    }
    return photon_program(benchmark_skin(), request);
}

/// mark: a name that makes the text one that no driver has seen.
void time_photons(const BenchRun& run, bool absorbed, const std::string& mark, Stages& all)
{
    PhotonProgram program = skin_program(absorbed);
    program.preamble += fmt::format("typedef int {};\n", mark);
    std::unique_ptr<PhotonKernel> kernel;
    const auto build = [&](const Device& device) {
        kernel = std::make_unique<PhotonKernel>(device, program, 1);
    };
    const auto launch = [&] { kernel->run(0, 1); };
    const Device first = run.at_width(run.device.width()), second = run.at_width(first.width());
    all[0].push_back(seconds_on_the_wall([&] { build(first); }));
    all[1].push_back(seconds_on_the_wall(launch));
    all[2].push_back(seconds_on_the_wall(launch));
    all[3].push_back(seconds_on_the_wall([&] { build(second); }));
    all[4].push_back(seconds_on_the_wall(launch));
}

/// Of a table's program what the driver remembers, once it has seen it.
void time_table(const BenchRun& run, const Lobe& lobe, Stages& all)
{
    const Material material{"start", {lobe}};
    const DirectionTables tables =
        direction_tables(isotropic_grid(4, 4, 32, Samples::centre, 180), false);
    for (const bool counts : {false, true}) {
        const Device device = run.at_width(run.device.width());
        std::unique_ptr<GridKernel> kernel;
        const double build = seconds_on_the_wall([&] {
            kernel = std::make_unique<GridKernel>(
                device.state(), material, tables,
                TableProgram{"", Measure::brdf, false, false, device.width()});
        });
        OutputBuffer out(device.state(), tables.rows * tables.length);
        const double launch = seconds_on_the_wall([&] { kernel->enqueue(out, 0, 1).wait(); });
        if (!counts) continue;
        all[3].push_back(build);
        all[4].push_back(launch);
    }
}

void add_points(BenchPlot& plot, const std::string& series, Stages& all)
{
    for (std::size_t k = 0; k < stages.size(); ++k)
        if (!all[k].empty())
            plot.points.push_back(
                {series, stages[k], exactly(double(k + 1)), quartiles_of(std::move(all[k]))});
}

}  // namespace

BenchPlot bench_start(const BenchRun& run)
{
    BenchPlot plot{
        "start", "Until a program runs",
        "Build: of a program that the driver has never seen (a name in it is new). First launch: "
        "in it some drivers compile. Cached build: of the same text in a new context, where the "
        "driver may remember it. Of tables only what comes from there on.",
        "stage", "seconds"};
    plot.x_names = {stages.begin(), stages.end()};
    plot.x_logarithmic = false;
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    const int rounds = run.quick ? 1 : 3;
    for (const bool absorbed : {false, true}) {
        Stages all;
        for (int round = 0; round < rounds; ++round) {
            run.step("start: photons");
            time_photons(run, absorbed, fmt::format("mark_{}_{}", now, round), all);
        }
        add_points(plot, absorbed ? "photons, with A(r, z)" : "photons, totals", all);
    }
    for (const std::string_view model : {"lambert", "torrance_sparrow", "he_torrance"}) {
        Stages all;
        for (int round = 0; round < rounds; ++round) {
            run.step(fmt::format("start: {}", model));
            time_table(run, default_lobe(model), all);
        }
        add_points(plot, fmt::format("table of {}", model), all);
    }
    return plot;
}

}  // namespace gonio

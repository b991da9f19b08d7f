// SPDX-License-Identifier: Apache-2.0
// Every model of the registry on an isotropic grid with the azimuth innermost, without symmetry, so
// that every cell is an evaluation. Each is timed in turn with the store kernel and with the C++
// peers; figures are medians.
//   Geval_per_s  evaluations per second      of_store    as a fraction of the store kernel's rate
//   vs_tables    times the C++ table form    vs_textbook times the C++ textbook form
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <numbers>

#include "compute/peers.hpp"
#include "opencl/grid_kernel.hpp"
#include "opencl/store_rate.hpp"

namespace gonio {
namespace {

constexpr std::size_t thetas = 128, columns = 1024, cells = thetas * thetas * columns;

double median(std::vector<double> values)
{
    std::ranges::nth_element(values,
                             values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

double seconds(const bench::Peer& peer, const bench::PeerGrid& grid, std::vector<float>& out)
{
    const auto start = std::chrono::steady_clock::now();
    peer(grid, out.data());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bench::PeerGrid peer_grid(const Grid& grid)
{
    const auto radians = [](const Axis& axis) {
        std::vector<float> values;
        for (const double degrees : axis.values)
            values.push_back(static_cast<float>(degrees * std::numbers::pi / 180));
        return values;
    };
    return {radians(grid.axes[0]), radians(grid.axes[1]), radians(grid.axes[2])};
}

void table(benchmark::State& state, const Model& model)
{
    const Device device;
    const Material material{std::string(model.id), {default_lobe(model.id)}};
    const Grid grid = isotropic_grid(thetas, thetas, columns, Samples::centre, 180);
    const DirectionTables tables = direction_tables(grid, false);
    GridKernel kernel(device.state(), material, tables,
                      {"", Measure::brdf, false, false, device.width()});
    OutputBuffer out(device.state(), cells);
    const auto peer =
        std::ranges::find(bench::peers(), std::string(model.id), &bench::Peers::model);
    const bench::PeerGrid angles = peer_grid(grid);
    std::vector<float> host(peer == bench::peers().end() ? 0 : cells);
    StoreRate store(device.state());

    std::vector<double> own, stored, with_tables, textbook;
    kernel.enqueue(out, 0, tables.rows).wait();  // touches the pages
    for (auto _ : state) {
        cl::Event event = kernel.enqueue(out, 0, tables.rows);
        event.wait();
        own.push_back(seconds_of(event));
        state.SetIterationTime(own.back());
        stored.push_back(store.seconds());
        if (host.empty()) continue;
        with_tables.push_back(seconds(peer->tables, angles, host));
        textbook.push_back(seconds(peer->textbook, angles, host));
    }
    state.counters["Geval_per_s"] = static_cast<double>(cells) / median(own) * 1e-9;
    state.counters["of_store"] =
        median(stored) / median(own) * static_cast<double>(cells) / StoreRate::count;
    if (host.empty()) return;
    state.counters["vs_tables"] = median(with_tables) / median(own);
    state.counters["vs_textbook"] = median(textbook) / median(own);
}

const bool registered = [] {
    for (const Model& model : models())
        benchmark::RegisterBenchmark(("table/" + std::string(model.id)).c_str(),
                                     [&model](benchmark::State& state) { table(state, model); })
            ->UseManualTime()
            ->Iterations(15)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace gonio

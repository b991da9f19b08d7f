// SPDX-License-Identifier: Apache-2.0
// How work grows with compute units, and tables with the size of their tiles.
#include <fmt/format.h>

#include "gonio/compute.hpp"
#include "opencl/fission.hpp"
#include "opencl/photon_kernel.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr std::size_t thetas = 64, azimuths = 1024;
constexpr std::uint32_t photons = 20'000;

double table_seconds(const Device& device, std::size_t tile_bytes)
{
    static const Material ggx{"ggx", {default_lobe("ggx")}};
    static const Grid grid = isotropic_grid(thetas, thetas, azimuths, Samples::centre, 180);
    return seconds_on_the_wall([&] {
        compute_grid(device, ggx, Measure::brdf, grid, [](const Rows<float>&) {},
                     {.leave_out = false, .tile_bytes = tile_bytes});
    });
}

}  // namespace

BenchPlot bench_scaling(const BenchRun& run)
{
    BenchPlot plot{
        "scaling", "Over compute units",
        "Parts of the device (device fission, where it has it) compute a table of GGX "
        "(million values a second, by the wall's clock) and photons in skin (thousands a "
        "second, by the device's).",
        "compute units", "rate"};
    plot.x_logarithmic = plot.y_logarithmic = false;
    std::vector<Device> parts;
    for (unsigned units = 1; units < run.device.info().compute_units; units *= 2)
        if (const auto part = part_of(run.device, units)) parts.push_back(*part);
    parts.push_back(run.device);
    std::vector<std::unique_ptr<PhotonKernel>> kernels;
    std::vector<std::function<double()>> runs;
    for (const Device& part : parts) {
        run.step(fmt::format("scaling: {} compute units", part.info().compute_units));
        kernels.push_back(
            std::make_unique<PhotonKernel>(part, photon_program(benchmark_skin(), {}), 1));
        PhotonKernel& kernel = *kernels.back();
        kernel.run(0, photons);
        table_seconds(part, std::size_t{64} << 20);
        runs.emplace_back([&part] { return table_seconds(part, std::size_t{64} << 20); });
        runs.emplace_back([&kernel] { return kernel.run(0, photons); });
    }
    const std::vector<Quartiles> seconds = interleaved(runs, run.rounds());
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const unsigned units = parts[k].info().compute_units;
        const auto add = [&](const char* series, double amount, const Quartiles& took) {
            plot.points.push_back(
                {series, fmt::format("{} units", units), exactly(units), rate_of(amount, took)});
        };
        add("table, million values/s", double(thetas * thetas * azimuths) * 1e-6, seconds[2 * k]);
        add("photons, thousands/s", photons * 1e-3, seconds[2 * k + 1]);
    }
    return plot;
}

BenchPlot bench_tiles(const BenchRun& run)
{
    BenchPlot plot{
        "tiles", "Over sizes of tiles",
        "A table of GGX of 16 MiB in tiles of at most so many bytes, by the wall's clock.",
        "MiB in a tile", "million values per second"};
    plot.y_logarithmic = false;
    std::vector<std::function<double()>> runs;
    std::vector<std::size_t> sizes;
    for (std::size_t bytes = std::size_t{1} << 16; bytes <= std::size_t{1} << 26; bytes *= 4)
        sizes.push_back(bytes);
    run.step("tiles");
    for (const std::size_t bytes : sizes)
        runs.emplace_back([&run, bytes] { return table_seconds(run.device, bytes); });
    runs.front()();
    const std::vector<Quartiles> seconds = interleaved(runs, run.rounds());
    for (std::size_t k = 0; k < sizes.size(); ++k)
        plot.points.push_back({"ggx", fmt::format("{} KiB", sizes[k] >> 10),
                               exactly(double(sizes[k]) * 0x1p-20),
                               rate_of(double(thetas * thetas * azimuths) * 1e-6, seconds[k])});
    return plot;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Random numbers: how fast a generator is, and whether it bends the answer.
#include <fmt/format.h>

#include <cmath>

#include "parallel.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/scalar_monte_carlo.hpp"
#include "timings/generators.hpp"
#include "timings/sections.hpp"

namespace gonio {
namespace {

/// Five layers of skin at 633 nm: Tuchin 1997, as GPU-MCML ships them.
LayeredMedium five_layers()
{
    const auto layer = [](double mua, double mus, double g, double n, double d) {
        return Layer{mua, mus, n, d, HenyeyGreenstein{g}};
    };
    return {.layers = {layer(4.3, 107, 0.79, 1.5, 0.01), layer(2.7, 187, 0.82, 1.4, 0.02),
                       layer(3.3, 192, 0.82, 1.4, 0.02), layer(2.7, 187, 0.82, 1.4, 0.09),
                       layer(3.4, 194, 0.82, 1.4, 0.06)}};
}

constexpr std::size_t batches = 64;

double nanoseconds_each(const Generator& generator)
{
    constexpr int count = 2'000'000;
    constexpr int of_a_photon = 100;
    const Numbers numbers = generator.make(1, 1024);
    double sum = 0;
    const double seconds = seconds_on_the_wall([&] {
        for (int k = 0; k < count; ++k) {
            if (numbers.begin && k % of_a_photon == 0)
                numbers.begin(static_cast<std::size_t>(k / of_a_photon));
            sum += numbers.uniform();
        }
    });
    return sum > 0 ? seconds * 1e9 / count : 0;
}

}  // namespace

BenchPlot bench_generators(const BenchRun& run)
{
    BenchPlot plot{
        "generators", "Random numbers: speed, and what they do to the answer",
        "The scalar Monte Carlo of the reference through five layers of skin, with each "
        "generator: by how many standard errors the diffuse transmittance is off that of "
        "adding-doubling (beyond 3 or 4 it is the generator). Time of a number through a "
        "function call, on one core of the host, where all of them run; the device has "
        "xoshiro128++ seeded by Philox only. Sobol's points are eight dimensions, a hundred "
        "numbers a photon, and their own standard error is in the results.",
        "ns per number", "off by, standard errors"};
    plot.joined = plot.x_logarithmic = plot.y_logarithmic = false;
    const LayeredMedium medium = five_layers();
    const double right = reference::solve_layers_once(medium, {.incidence = {0}}, 96)
                             .collimated[0]
                             .budget.diffuse_transmittance;
    const std::size_t batch = run.quick ? 512 : 16'384, photons = batches * batch;
    run.step("generators");
    std::vector<reference::Estimate> found(generators().size());
    in_parallel(found.size(), [&](std::size_t k) {
        const Numbers numbers = generators()[k].make(12345, batch);
        found[k] = reference::simulate(medium, {.photons = photons,
                                                .uniform = numbers.uniform,
                                                .before_photon = numbers.begin,
                                                .batches = batches,
                                                .r_bins = 1,
                                                .z_bins = 1})
                       .diffuse_transmittance;
    });
    std::vector<std::function<double()>> runs;
    for (const Generator& generator : generators())
        runs.emplace_back([&generator] { return nanoseconds_each(generator); });
    const std::vector<Quartiles> speeds = interleaved(runs, run.rounds());
    for (std::size_t k = 0; k < found.size(); ++k)
        plot.points.push_back({std::string(generators()[k].name),
                               fmt::format("{} photons", photons),
                               speeds[k],
                               exactly(std::abs(found[k].mean - right) / found[k].error),
                               false,
                               {{"relative_bias", found[k].mean / right - 1},
                                {"relative_standard_error", found[k].error / right}}});
    return plot;
}

}  // namespace gonio

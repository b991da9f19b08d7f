// SPDX-License-Identifier: Apache-2.0
// Random numbers: how fast a generator is, and whether it bends the answer, on the host.
#include <fmt/format.h>

#include "parallel.hpp"
#include "reference/scalar_monte_carlo.hpp"
#include "timings/five_layers.hpp"
#include "timings/generators.hpp"
#include "timings/sections.hpp"

namespace gonio {
namespace {

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
        "The scalar Monte Carlo of the reference through five layers of skin, drawing numbers in "
        "MCML's order, with each generator: by how many standard errors the diffuse transmittance "
        "is off that of adding-doubling (beyond 3 or 4 it is the generator). Time of a number "
        "through a "
        "function call, on one core of the host, where all of them run. Sobol's points are eight "
        "dimensions, a hundred numbers a photon, and their own standard error is in the results.",
        "ns per number", "off by, standard errors"};
    plot.joined = plot.x_logarithmic = plot.y_logarithmic = false;
    plot.note += run.quick
                     ? " This quick run has too few photons to show what is bad: the lagged "
                       "Fibonacci generator is about 3 % off, and so is chance."
                     : " Of the bad ones the lagged Fibonacci generator shows, the other not.";
    const LayeredMedium medium = five_layers();
    const double right = right_transmittance();
    const std::size_t batch = run.quick ? 512 : 16'384, photons = generator_batches * batch;
    run.step("generators");
    std::vector<reference::Estimate> found(generators().size());
    in_parallel(found.size(), [&](std::size_t k) {
        const Numbers numbers = generators()[k].make(12345, batch);
        found[k] = reference::simulate(medium, {.photons = photons,
                                                .uniform = numbers.uniform,
                                                .before_photon = numbers.begin,
                                                .batches = generator_batches,
                                                .draws_at_all_boundaries = true,
                                                .r_bins = 1,
                                                .z_bins = 1})
                       .diffuse_transmittance;
    });
    std::vector<std::function<double()>> runs;
    for (const Generator& generator : generators())
        runs.emplace_back([&generator] { return nanoseconds_each(generator); });
    const std::vector<Quartiles> speeds = interleaved(runs, run.rounds());
    for (std::size_t k = 0; k < found.size(); ++k)
        plot.points.push_back(compared(generators()[k].name, photons, speeds[k],
                                       {found[k].mean, found[k].error}, right));
    return plot;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Random numbers: how the error falls with their number, or stays where the generator bends it.
#include <fmt/format.h>

#include <cmath>

#include "parallel.hpp"
#include "reference/scalar_monte_carlo.hpp"
#include "timings/five_layers.hpp"
#include "timings/generators.hpp"
#include "timings/relative_error.hpp"
#include "timings/sections.hpp"

namespace gonio {
namespace {

/// The diffuse transmittance by consecutive photons of one stream, block by block.
std::vector<double> transmittances(const Generator& generator, std::size_t blocks,
                                   std::size_t photons)
{
    const Numbers numbers = generator.make(12345, blocks * photons);
    std::vector<double> means;
    for (std::size_t block = 0; block < blocks; ++block)
        means.push_back(
            reference::simulate(five_layers(), {.photons = photons,
                                                .uniform = [&] { return numbers.uniform(); },
                                                .before_photon =
                                                    [&](std::size_t k) {
                                                        if (numbers.begin)
                                                            numbers.begin(block * photons + k);
                                                    },
                                                .batches = 2,
                                                .draws_at_all_boundaries = true,
                                                .r_bins = 1,
                                                .z_bins = 1})
                .diffuse_transmittance.mean);
    return means;
}

/// The root of the mean square over blocks.
double error_of(const std::vector<double>& means, double right)
{
    return relative_error(means, std::vector<double>(means.size(), right));
}

/// Twice as many photons in each.
std::vector<double> merged(const std::vector<double>& means)
{
    std::vector<double> pairs;
    for (std::size_t k = 0; k + 1 < means.size(); k += 2)
        pairs.push_back((means[k] + means[k + 1]) / 2);
    return pairs;
}

}  // namespace

BenchPlot bench_generator_errors(const BenchRun& run)
{
    BenchPlot plot{"generator-errors", "Random numbers: error against photons",
                   "The same layers: the relative error of the diffuse transmittance by blocks of "
                   "so many consecutive photons, root of the mean square over all blocks of one "
                   "stream. A good generator follows the line, but for what chance does to the "
                   "last points, four blocks.",
                   "photons", "relative error"};
    constexpr std::size_t blocks = 64, least = 4;  // of the largest
    const std::size_t photons = run.quick ? 64 : 8192;
    run.step("generator-errors");
    const double right = right_transmittance();
    std::vector<std::vector<double>> means(generators().size());
    in_parallel(means.size(), [&](std::size_t k) {
        means[k] = transmittances(generators()[k], blocks, photons);
    });
    double one = 0;  // error of a photon
    for (std::size_t k = 0; k < means.size(); ++k) {
        if (k == 0) one = error_of(means[0], right) * std::sqrt(double(photons));
        for (std::size_t size = photons; means[k].size() >= least;
             size *= 2, means[k] = merged(means[k]))
            plot.points.push_back({std::string(generators()[k].name),
                                   fmt::format("{} photons", size), exactly(double(size)),
                                   exactly(error_of(means[k], right))});
    }
    for (const std::size_t size : {photons, blocks / least * photons})
        plot.points.push_back({"slope -1/2", fmt::format("{} photons", size), exactly(double(size)),
                               exactly(one / std::sqrt(double(size)))});
    return plot;
}

}  // namespace gonio

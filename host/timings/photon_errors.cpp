// SPDX-License-Identifier: Apache-2.0
// How the errors of photons fall with time: those that they have, and those that they tell.
#include "timings/photon_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/interrupt.hpp"
#include "timings/relative_error.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

/// Of all seeds, one behind the other.
struct Found {
    std::vector<double> means, errors, right;

    void add(const std::vector<Fraction>& values, const std::vector<double>& known)
    {
        for (std::size_t k = 0; k < values.size(); ++k) {
            means.push_back(values[k].mean);
            errors.push_back(values[k].error);
        }
        right.insert(right.end(), known.begin(), known.end());
    }
};

}  // namespace

void add_photons(BenchPlot& plot, const BenchRun& run, const PhotonTallies& tallies,
                 const std::vector<PhotonNumbers>& all, int most_power)
{
    const LayeredMedium medium = benchmark_skin();
    const std::uint64_t seeds = run.quick ? 4 : 9;
    for (int power = 12; power <= most_power; power += 2) {
        const std::uint64_t photons = std::uint64_t{1} << power;
        run.step(fmt::format("{}: {}, 2^{}", plot.id, all.front().name, power));
        std::vector<Found> found(all.size());
        std::vector<double> seconds;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            PhotonTracer tracer(run.device, medium,
                                {.tallies = tallies, .seed = seed, .batch = photons / 16});
            tracer.trace(photons, [](std::uint64_t) { throw_if_interrupted(); });
            seconds.push_back(tracer.kernel_seconds());
            const PhotonResult result = tracer.result();
            for (std::size_t k = 0; k < all.size(); ++k)
                found[k].add(all[k].of(result), all[k].right);
        }
        const Quartiles took = quartiles_of(std::move(seconds));
        const std::string label = fmt::format("2^{} photons", power);
        for (std::size_t k = 0; k < all.size(); ++k) {
            const auto& [means, errors, right] = found[k];
            if (!right.empty())
                plot.points.push_back(
                    {all[k].name + ", true", label, took, exactly(relative_error(means, right))});
            plot.points.push_back({all[k].name + ", standard error", label, took,
                                   exactly(root_mean_square(errors) / root_mean_square(means))});
        }
    }
}

void add_slope(BenchPlot& plot)
{
    const BenchPoint longest = plot.points.back();
    const double first =
        std::ranges::find(plot.points, longest.series, &BenchPoint::series)->x.median;
    const double last = longest.x.median, error = longest.y.median;
    plot.points.push_back(
        {"slope -1/2", "shortest run", exactly(first), exactly(error * std::sqrt(last / first))});
    plot.points.push_back({"slope -1/2", "longest run", exactly(last), exactly(error)});
}

}  // namespace gonio

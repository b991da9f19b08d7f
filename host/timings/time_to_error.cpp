// SPDX-License-Identifier: Apache-2.0
// How long each solver takes to an asked error.
#include <fmt/format.h>

#include <cmath>

#include "gonio/photons.hpp"
#include "plan/interrupt.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr std::array asked_errors{1e-2, 1e-3, 1e-4, 1e-5};

/// The fewest directions at which Rd is right to `error`, and their time.
BenchPoint by_adding_doubling(const BenchRun& run, const LayeredMedium& medium, double right,
                              double error)
{
    for (int nodes = 6;; nodes += 2) {
        double found = 0;
        const auto solve = [&] {
            found = reference::solve_layers_once(medium, {.incidence = {0}}, nodes)
                        .collimated[0]
                        .budget.diffuse_reflectance;
        };
        solve();
        if (std::abs(found / right - 1) > error) continue;
        return {"adding-doubling", fmt::format("{:.0e}: {} directions", error, nodes),
                exactly(error),
                interleaved({[&] { return seconds_on_the_wall(solve); }}, run.rounds()).front()};
    }
}

}  // namespace

BenchPlot bench_time_to_error(const BenchRun& run)
{
    BenchPlot plot{
        "time-to-error", "Seconds to an asked error of Rd",
        "The skin of the photons' plot. Photons: from the standard error that a run of a "
        "known time has reached, as errors fall with the root of the time; a time above that "
        "of the run is therefore extrapolated. Adding-doubling: the fewest directions that "
        "are right.",
        "asked relative error", "seconds"};
    const LayeredMedium medium = benchmark_skin();
    run.step("time-to-error: photons");
    const double right = exact_light(medium).diffuse_reflectance;
    const std::uint64_t photons = std::uint64_t{1} << (run.quick ? 17 : 21);
    std::vector<double> squares;  // of the error after a second
    double longest = 0;
    for (int round = 0; round < run.rounds(); ++round) {
        PhotonTracer tracer(run.device, medium,
                            {.seed = std::uint64_t(round), .batch = photons / 64});
        tracer.trace(photons, [](std::uint64_t) { throw_if_interrupted(); });
        const Fraction rd = tracer.result().diffuse_reflectance;
        squares.push_back(rd.error * rd.error / (rd.mean * rd.mean) * tracer.kernel_seconds());
        longest = std::max(longest, tracer.kernel_seconds());
    }
    const Quartiles figure = quartiles_of(std::move(squares));
    for (const double error : asked_errors) {
        const double scale = 1 / (error * error);
        const Quartiles seconds{figure.median * scale, figure.low * scale, figure.high * scale};
        plot.points.push_back({"photons",
                               fmt::format("{:.0e}", error),
                               exactly(error),
                               seconds,
                               false,
                               {{"extrapolated", double(seconds.median > longest)}}});
    }
    for (const double error : asked_errors) {
        run.step(fmt::format("time-to-error: adding-doubling to {:.0e}", error));
        plot.points.push_back(by_adding_doubling(run, medium, right, error));
    }
    return plot;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Skin of seven layers: photons on the device and adding-doubling on the host.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gonio/photons.hpp"
#include "plan/interrupt.hpp"
#include "reference/adding_doubling.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr std::size_t radii = 20;

/// What photons find, over what is right.
struct Errors {
    std::vector<double> squares;

    void add(double found, double right)
    {
        squares.push_back((found / right - 1) * (found / right - 1));
    }
    double root_mean_square() const
    {
        double sum = 0;
        for (const double square : squares) sum += square;
        return std::sqrt(sum / double(squares.size()));
    }
};

PhotonRequest request(std::uint64_t seed, std::uint64_t photons)
{
    PhotonRequest asked{.seed = seed, .batch = std::max<std::uint64_t>(photons / 16, 2)};
    asked.tallies.reflected = true;
    asked.tallies.rows = radii;
    asked.tallies.radius_width = 0.02;
    asked.tallies.angles = 1;
    return asked;
}

/// The line on which errors fall with the root of the time, through the longest run's Rd.
void add_slope(BenchPlot& plot)
{
    const auto last = std::ranges::find(plot.points.rbegin(), plot.points.rend(),
                                        "photons: Rd, reported", &BenchPoint::series);
    const double seconds = last->x.median, error = last->y.median;
    for (const double times : {1 / 4096.0, 1.0})
        plot.points.push_back({"slope -1/2", fmt::format("{:.3g} of the longest run", times),
                               exactly(seconds * times), exactly(error / std::sqrt(times))});
}

}  // namespace

BenchPlot bench_photons(const BenchRun& run)
{
    BenchPlot plot{
        "photons", "Light in skin of seven layers",
        "meglinski_2002 at 633 nm under a pencil beam, with R(r) tallied. True errors are "
        "against adding-doubling with 160 directions, as the root of the mean square over "
        "several seeds (and over layers); reported ones are the run's own standard errors, "
        "relative, of R(r) over the bins to 0.4 cm. Times of photons by the device's clock, "
        "on all its units; of adding-doubling on one core.",
        "seconds", "relative error"};
    const LayeredMedium medium = benchmark_skin();
    run.step("photons: what is right");
    const reference::LightBudget exact = exact_light(medium);
    const int seeds = run.quick ? 4 : 9;
    const int powers = run.quick ? 18 : 23;
    for (int power = 12; power <= powers; power += 2) {
        const std::uint64_t photons = std::uint64_t{1} << power;
        run.step(fmt::format("photons: 2^{}", power));
        Errors reflectance, absorption, reported, profile;
        std::vector<double> seconds;
        for (int seed = 1; seed <= seeds; ++seed) {
            PhotonTracer tracer(run.device, medium, request(std::uint64_t(seed), photons));
            tracer.trace(photons, [](std::uint64_t) { throw_if_interrupted(); });
            const PhotonResult result = tracer.result();
            seconds.push_back(tracer.kernel_seconds());
            reflectance.add(result.diffuse_reflectance.mean, exact.diffuse_reflectance);
            for (std::size_t k = 0; k < exact.absorption.size(); ++k)
                absorption.add(result.absorption[k].mean, exact.absorption[k]);
            const Fraction& rd = result.diffuse_reflectance;
            reported.add(rd.mean + rd.error, rd.mean);
            for (std::size_t k = 0; k < radii; ++k) {
                const Fraction& bin = result.reflected[k];
                if (bin.mean > 0) profile.add(bin.mean + bin.error, bin.mean);
            }
        }
        const Quartiles took = quartiles_of(std::move(seconds));
        const std::string label = fmt::format("2^{} photons", power);
        plot.points.push_back(
            {"photons: Rd, true", label, took, exactly(reflectance.root_mean_square())});
        plot.points.push_back(
            {"photons: Rd, reported", label, took, exactly(reported.root_mean_square())});
        plot.points.push_back({"photons: absorption by layer, true", label, took,
                               exactly(absorption.root_mean_square())});
        plot.points.push_back(
            {"photons: R(r), reported", label, took, exactly(profile.root_mean_square())});
    }
    std::vector<Candidate> solvers;
    for (const int nodes : {6, 8, 12, 16, 24, 32, 48, 64, 96}) {
        const auto solve = [&medium, nodes] {
            return reference::solve_layers_once(medium, {.incidence = {0}}, nodes)
                .collimated[0]
                .budget;
        };
        run.step(fmt::format("photons: adding-doubling, {} directions", nodes));
        const reference::LightBudget found = solve();
        Errors errors;
        errors.add(found.diffuse_reflectance, exact.diffuse_reflectance);
        for (std::size_t k = 0; k < exact.absorption.size(); ++k)
            errors.add(found.absorption[k], exact.absorption[k]);
        solvers.push_back({{"adding-doubling: Rd and layers",
                            fmt::format("{} directions", nodes),
                            {},
                            exactly(errors.root_mean_square())},
                           [solve] { return seconds_on_the_wall(solve); }});
    }
    time_in_turn(plot, std::move(solvers), run.rounds());
    mark_best(plot);
    add_slope(plot);
    return plot;
}

}  // namespace gonio

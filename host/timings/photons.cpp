// SPDX-License-Identifier: Apache-2.0
// Skin of seven layers: photons on the device and adding-doubling on the host.
#include <fmt/format.h>

#include "reference/adding_doubling.hpp"
#include "timings/photon_errors.hpp"
#include "timings/relative_error.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

/// Both transmittances: what is never scattered does not come through skin.
std::vector<double> numbers_of(const reference::LightBudget& budget)
{
    std::vector numbers{budget.diffuse_reflectance,
                        budget.unscattered_transmittance + budget.diffuse_transmittance};
    numbers.insert(numbers.end(), budget.absorption.begin(), budget.absorption.end());
    return numbers;
}

void add_adding_doubling(BenchPlot& plot, const BenchRun& run, const LayeredMedium& medium,
                         const reference::LightBudget& exact)
{
    std::vector<Candidate> solvers;
    for (const int nodes : {6, 8, 12, 16, 24, 32, 48, 64, 96}) {
        const auto solve = [&medium, nodes] {
            return reference::solve_layers_once(medium, {.incidence = {0}}, nodes)
                .collimated[0]
                .budget;
        };
        run.step(fmt::format("photons: adding-doubling, {} directions", nodes));
        solvers.push_back({{"adding-doubling: all of them",
                            fmt::format("{} directions", nodes),
                            {},
                            exactly(relative_error(numbers_of(solve()), numbers_of(exact)))},
                           [solve] { return seconds_on_the_wall(solve); }});
    }
    time_in_turn(plot, std::move(solvers), run.rounds());
}

}  // namespace

BenchPlot bench_photons(const BenchRun& run)
{
    BenchPlot plot{
        "photons", "Light in skin of seven layers",
        "meglinski_2002 at 633 nm under a pencil beam: diffuse reflectance Rd, total transmittance "
        "T, and the absorption A of each layer. True errors are against adding-doubling with 160 "
        "directions, standard errors those that the run tells; roots of the mean square over "
        "several seeds (and over layers), over that of the numbers themselves. Times of photons by "
        "the device's clock, on all its units; of adding-doubling on one core.",
        "seconds", "relative error"};
    const LayeredMedium medium = benchmark_skin();
    run.step("photons: what is right");
    const reference::LightBudget exact = exact_light(medium);
    add_adding_doubling(plot, run, medium, exact);
    const double transmitted = exact.unscattered_transmittance + exact.diffuse_transmittance;
    add_photons(
        plot, run, {},
        {{"A of layers", exact.absorption,
          [](const PhotonResult& result) { return result.absorption; }},
         {"T",
          {transmitted},
          [](const PhotonResult& result) { return std::vector{result.diffuse_transmittance}; }},
         {"Rd",
          {exact.diffuse_reflectance},
          [](const PhotonResult& result) { return std::vector{result.diffuse_reflectance}; }}},
        run.quick ? 18 : 22);
    mark_best(plot);
    add_slope(plot);
    return plot;
}

}  // namespace gonio

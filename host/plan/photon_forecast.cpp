// SPDX-License-Identifier: Apache-2.0
// What tables of layers by Monte Carlo will cost: errors fall with the root of the photons.
#include <algorithm>
#include <cmath>

#include "photon/asked_layers.hpp"
#include "photon/simulation.hpp"
#include "plan/forecast_parts.hpp"

namespace gonio {

Forecast photon_forecast(const Device& device, const Job& job)
{
    constexpr std::uint64_t followed = 1 << 15;
    Job pilot = job;
    pilot.layers->medium = asked_layers(job).medium;
    pilot.layers->budget = {};
    const std::size_t parts = lights_of(job).size();
    pilot.layers->budget.photons = followed / parts;
    pilot.must_reach = false;
    pilot.path += ".forecast";  // where no earlier run has left a checkpoint
    const LightTable found = simulate(device, pilot, [](const LightProgress&) {}).table;

    const Budget& budget = job.layers->budget;
    const auto photons = static_cast<double>(found.photons);
    if (std::isinf(found.error) && !budget.photons && !budget.seconds) return {.seconds = NAN};
    double times = INFINITY;  // as many photons
    if (budget.photons)
        times = static_cast<double>(*budget.photons) * static_cast<double>(parts) / photons;
    if (budget.seconds)
        times = std::min(times, *budget.seconds * found.photons_per_second / photons);
    if (budget.max_error) times = std::min(times, std::pow(found.error / *budget.max_error, 2));
    times = std::max(times, 1 / photons);
    return {.seconds = times * photons / found.photons_per_second,
            .error = std::isinf(found.error) ? NAN : found.error / std::sqrt(times),
            .error_of = "the largest value",
            .is_bound = false,
            .photons = times * photons};
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What a table by photons will cost: the error falls with the root of their number.
#include "plan/photon_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "photon/asked_layers.hpp"
#include "photon/simulation.hpp"

namespace gonio {

PhotonForecast forecast(const Device& device, const Job& job)
{
    constexpr std::uint64_t followed = 1 << 15;
    Job pilot = job;
    pilot.layers->medium = asked_layers(job).medium;
    pilot.layers->budget = {};
    const std::size_t parts =
        job.layers->quantity->on_grid() ? job.header.axes[0].values.size() : 1;
    pilot.layers->budget.photons = followed / parts;
    pilot.must_reach = false;
    pilot.path += ".forecast";  // where no earlier run has left a checkpoint
    const LightTable found = simulate(device, pilot, [](const LightProgress&) {}).table;

    const Budget& budget = job.layers->budget;
    const auto photons = static_cast<double>(found.photons);
    double times = INFINITY;  // as many photons
    if (budget.photons)
        times = static_cast<double>(*budget.photons) * static_cast<double>(parts) / photons;
    if (budget.seconds)
        times = std::min(times, *budget.seconds * found.photons_per_second / photons);
    if (budget.max_error) times = std::min(times, std::pow(found.error / *budget.max_error, 2));
    return {times * photons, times * photons / found.photons_per_second,
            found.error / std::sqrt(times)};
}

}  // namespace gonio

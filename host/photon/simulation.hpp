// SPDX-License-Identifier: Apache-2.0
// A table of layers by Monte Carlo, until a budget ends.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/job.hpp"
#include "gonio/photons.hpp"
#include "photon/light_table.hpp"

namespace gonio {

/// The light of each part of a table, which has photons of its own: for a BRDF a beam for each of
/// its directions.
std::vector<LightSource> lights_of(const Job& job);

struct SimulatedValues {
    std::vector<Fraction> values;  ///< in the order of the table
    LightTable table;
};

/// Goes on where an earlier run of the same job ended before its time, to the same bytes. Throws
/// RunError where the budget ended before a max_error that must be reached.
SimulatedValues simulate(const Device& device, const Job& job,
                         const std::function<void(const LightProgress&)>& after_launch);

/// Forgets where a simulation was, once its table is there.
void forget_simulation(const Job& job);

}  // namespace gonio

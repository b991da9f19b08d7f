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

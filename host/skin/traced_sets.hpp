// SPDX-License-Identifier: Apache-2.0
// Sets of skin whose photons are followed, one set after the other, with a checkpoint.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/job.hpp"
#include "skin/resumable.hpp"

namespace gonio {

/// What a job's sets have given so far.
struct TracedSets {
    Table table;
    nlohmann::ordered_json beside = nlohmann::ordered_json::array();  ///< of each set
};

/// Appends the values of one set to the table and returns what belongs beside them; `from` and
/// `after_launch` as in trace_spectrum().
using TraceSet = std::function<nlohmann::ordered_json(
    const Skin& set, Table& table, const nlohmann::ordered_json& from, const AfterLaunch&)>;

/// Goes on where an earlier run of the same job ended before its time, to the same values. What
/// `after_each` throws, which gets the part that is done, ends the work, and is a place to go on
/// from; forget_simulation() removes it.
TracedSets trace_sets(const Job& job, const std::function<void(double)>& after_each,
                      const TraceSet& trace);

}  // namespace gonio

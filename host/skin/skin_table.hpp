// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job with skin.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/job.hpp"

namespace gonio {

/// Solves all sets of the job's ladders without noise and writes the file; `after_each` gets the
/// part that is done, of one thread after the other. Returns what belongs beside it. Throws as
/// solve_skin() and write_table() do, with the job's place in front.
nlohmann::ordered_json make_skin_table(
    const Job& job, const std::function<void(double)>& after_each = [](double) {});

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job with skin.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/job.hpp"

namespace gonio {

/// Solves all sets of the job's ladders and writes the file; `after_each` as in solve_skin().
/// Returns what belongs beside it. Throws as solve_skin() and write_table() do, with the job's
/// place in front.
nlohmann::ordered_json make_skin_table(
    const Job& job, const std::function<void()>& after_each = [] {});

}  // namespace gonio

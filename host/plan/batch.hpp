// SPDX-License-Identifier: Apache-2.0
// Runs jobs in order and keeps what an earlier run has finished.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "gonio/job.hpp"
#include "plan/progress.hpp"

namespace gonio {

/// Computes a job's table and writes it to job.path; advances the progress by every cell. Returns
/// what happened (device, driver, timings) for the "run" of the sidecar.
using MakeTable = std::function<nlohmann::ordered_json(const Job&, Progress&)>;

/// Is there a complete file with this job's definition? Files appear under their names only when
/// they are complete.
bool is_finished(const Job& job);

struct BatchReport {
    std::size_t made = 0, kept = 0;
    std::size_t copied = 0;  ///< equal to another table of the batch
};

/// For each job the first before it whose file has the same bytes; nullptr where there is none.
std::vector<const Job*> equal_jobs(const std::vector<Job>& jobs);

/// Which tables to make: all, or those that no earlier run has finished.
enum class Keep { nothing, finished };

/// Makes directories, removes what killed runs left behind, and makes every job that is not
/// kept, with its sidecar; what equals an earlier one is copied, unless nothing is to be kept.
/// Throws UsageError before anything is computed if the tables do not fit onto the disk, RunError
/// if a directory cannot be made, Interrupted between two jobs; whatever was finished is kept.
BatchReport run_batch(const std::vector<Job>& jobs, const MakeTable& make,
                      Keep keep = Keep::finished);

}  // namespace gonio

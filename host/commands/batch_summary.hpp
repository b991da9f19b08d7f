// SPDX-License-Identifier: Apache-2.0
// Runs jobs as `run` and `table` do: with progress, and a summary of what was made.
#pragma once

#include <vector>

#include "gonio/device.hpp"
#include "gonio/job.hpp"

namespace gonio {

/// Makes what is not finished and prints a line for each table. Throws as run_batch and make_table
/// do. leave_out: false to make all tables, all the general way.
void run_jobs(const Device& device, const std::vector<Job>& jobs, bool leave_out = true);

/// What --dry-run prints: size, memory and time of each job on this device.
void print_estimate(const Device& device, const std::vector<Job>& jobs);

}  // namespace gonio

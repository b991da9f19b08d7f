// SPDX-License-Identifier: Apache-2.0
// How many cells a time is enough for.
#pragma once

#include "gonio/compute.hpp"
#include "gonio/job.hpp"
#include "plan/fitted_grid.hpp"

namespace gonio {

/// The cells of the largest grid, in the proportions of `shape` and of at most `most` cells, whose
/// table is computed, checked and written in a time in seconds, as smaller ones are that it makes
/// beside the job's file. Takes about as long itself. Throws as make_table() does, and Interrupted.
double cells_in_time(const Device& device, const Job& job, const Counts& shape, double most,
                     double time, const ComputeOptions& options);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Grids as fine as a time allows.
#pragma once

#include <vector>

#include "gonio/compute.hpp"
#include "gonio/job.hpp"

namespace gonio {

/// Gives each job that has a fit and a time the finest grid whose table is computed, checked and
/// written in about that time, as smaller ones are that it makes beside its file; no finer one than
/// its max_error asks for. A table that an earlier run made in the same time keeps its grid, unless
/// nothing is to be left out. Throws as make_table() does.
void fit_to_time(const Device& device, std::vector<Job>& jobs, const ComputeOptions& options = {});

}  // namespace gonio

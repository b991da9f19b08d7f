// SPDX-License-Identifier: Apache-2.0
// Grids as fine as a time allows.
#pragma once

#include <vector>

#include "gonio/compute.hpp"
#include "gonio/job.hpp"

namespace gonio {

/// Gives jobs whose table an earlier run has chosen the grid of, for the same time, that grid; they
/// have no fit any more.
void keep_earlier_grids(std::vector<Job>& jobs);

/// Gives each job that has a fit and a time the finest grid whose table is computed, checked and
/// written in about that time, as smaller ones are that it makes beside its file; no finer one than
/// its max_error asks for. Earlier grids are kept, unless nothing is to be left out. Throws as
/// make_table() does, and Interrupted.
void fit_to_time(const Device& device, std::vector<Job>& jobs, const ComputeOptions& options = {});

}  // namespace gonio

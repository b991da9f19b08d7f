// SPDX-License-Identifier: Apache-2.0
// What a header tells of a table's grid.
#pragma once

#include <string>

#include "gonio/job.hpp"

namespace gonio {

/// The attributes `grid` and `directions` of a table over a grid.
std::string grid_name(GridKind kind);
std::string directions_text(GridKind kind);

/// Cells of a grid of angles theta_i and theta_o with one of them at exactly 90 deg.
std::size_t cells_at_the_horizon(const Grid& grid);

/// Says in the header how many samples at exactly 90 degrees hold 0 because the model has no limit
/// there.
void count_horizon(Job& job);

/// Another grid of the same kind for a job whose grid is fitted, in its header too.
void set_grid(Job& job, const Grid& grid, double interpolation_error);

}  // namespace gonio

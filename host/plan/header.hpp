// SPDX-License-Identifier: Apache-2.0
// The header of a planned table: all that determines its bytes, and what a reader must know.
#pragma once

#include <string>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

/// What parameters of each lobe are called among all: "" for a single lobe, else the model's id
/// with a dot, and a number where the model is there more than once ("ward_2.").
std::vector<std::string> lobe_prefixes(const std::vector<Lobe>& lobes);

/// The attributes `grid` and `directions` of a table over a grid.
std::string grid_name(GridKind kind);
std::string directions_text(GridKind kind);

/// Everything about a job's storage that changes the bytes of its file.
std::string storage_text(const Job& job);

/// A swept parameter as an axis of a table.
Axis sweep_axis(const Sweep& sweep, const std::vector<Lobe>& lobes);

/// The header of a job that has everything else. `swept` are its sweeps that are axes.
TableHeader make_header(const Job& job, const TableRequest& request,
                        const std::vector<Sweep>& swept);

/// The header of a job with layers, which has a name for its material and the table's axes.
TableHeader make_light_header(const Job& job, const std::string& material,
                              const std::vector<Axis>& axes);

/// Says in the header how many samples at exactly 90 degrees hold 0 because the model has no limit
/// there.
void count_horizon(Job& job);

/// Another grid of the same kind for a job whose grid is fitted, in its header too.
void set_grid(Job& job, const Grid& grid, double interpolation_error);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Where a pair of directions lies in a table.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// The grid of directions that the axes behind the swept ones are, told by their names.
std::optional<GridKind> grid_kind_of(const TableHeader& header);

/// The pair on the axes of such a grid, in degrees; of grids without a tangent frame only what they
/// tell apart.
std::vector<double> grid_coordinates(GridKind kind, const DirectionPair& pair);

}  // namespace gonio

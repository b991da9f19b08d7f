// SPDX-License-Identifier: Apache-2.0
// The tables that a grid's kernel reads, made in double: no kernel does trigonometry, and none
// subtracts angles.
#pragma once

#include <string>
#include <vector>

#include "gonio/grid.hpp"

namespace gonio {

/// The kernel's view of a grid or of a list of points. Layouts: gonio/shared/grid_fields.h.
struct DirectionTables {
    std::string grid_file;                    ///< the kernel file that reads them
    std::vector<std::vector<float>> buffers;  ///< in the order of its arguments
    std::vector<unsigned> counts;             ///< and the numbers behind them
    std::size_t length = 0;                   ///< cells in a row
    std::size_t rows = 0;
};

/// Tables of a grid; tangents only if a material needs a tangent frame.
DirectionTables direction_tables(const Grid& grid, bool tangents);

/// Tables of a list of points: one row.
DirectionTables direction_tables(const std::vector<DirectionPair>& points);

}  // namespace gonio

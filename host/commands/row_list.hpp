// SPDX-License-Identifier: Apache-2.0
// Lists of rows that a user gives as CSV: directions, or coordinates in a table.
#pragma once

#include <string>
#include <vector>

#include "gonio/grid.hpp"

namespace gonio {

struct Column {
    std::string name, unit;
    double least = 0, greatest = 0;
};

/// theta_i, phi_i, theta_o, phi_o in degrees.
std::vector<Column> direction_columns();

/// One number for each column in each row; a first line of names and lines that begin with # are
/// passed over. path: "-" is standard input. Throws UsageError that names file, line and column.
std::vector<std::vector<double>> read_rows(const std::string& path,
                                           const std::vector<Column>& columns);

/// Rows of direction_columns().
DirectionPair pair_of(const std::vector<double>& row);

}  // namespace gonio

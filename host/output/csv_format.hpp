// SPDX-License-Identifier: Apache-2.0
// What the CSV writer and the CSV reader agree on.
#pragma once

#include <string>
#include <vector>

#include "gonio/table.hpp"

namespace gonio {

constexpr const char* csv_first_line = "# gonio table 1";

/// The header row: the axes' names, then the channels'.
std::vector<std::string> csv_names(const TableHeader& header);

/// The unit row.
std::vector<std::string> csv_units(const TableHeader& header);

}  // namespace gonio

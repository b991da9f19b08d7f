// SPDX-License-Identifier: Apache-2.0
// Pictures of tables.
#pragma once

#include <filesystem>

#include "gonio/table.hpp"

namespace gonio {

/// Writes a table of one axis as curves, one for each channel with a band of its errors, or the
/// first channel of one of two axes as a map. Values that span much are shown by their logarithm.
/// The path's name tells PNG or SVG. Throws UsageError for tables of other shapes.
void write_table_plot(const std::filesystem::path& path, const Table& table);

}  // namespace gonio

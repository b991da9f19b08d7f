// SPDX-License-Identifier: Apache-2.0
// A table's header as OpenEXR headers, one per part. A part holds one combination of the swept
// axes' values; its rows are the other axes but the innermost, its columns the innermost.
//
// Attributes of every part: "gonio.table" (the header as JSON: what readers read, exact), and for
// people "quantity", "unit", "rows", "columns", "texels", "axis.<name>", "attribute.<name>",
// and "sweep.<axis>" with the part's value of each swept axis.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <string>
#include <vector>

#include "gonio/table.hpp"

namespace gonio {

constexpr const char* exr_table_attribute = "gonio.table";

/// Parts in an EXR file: combinations of the swept axes' values.
std::size_t exr_parts(const TableHeader& header);

/// "<quantity>.<channel>"
std::string exr_channel_name(const TableHeader& header, std::size_t channel);

/// Throws UsageError if an EXR part cannot be as large, or the compression is unknown.
std::vector<Imf::Header> exr_headers(const TableHeader& header, const WriteOptions& options);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The <stem>.json beside a table: its header, and what happened when it was computed.
//     { "format": "gonio table", "version": 1, "table": { ... }, "run": { ... } }
// "table" follows from the request alone (table_json.hpp); "run" holds device, driver, timings and
// the like, and readers ignore it. The schema is tests/output/table.schema.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "gonio/table.hpp"

namespace gonio {

/// tables/steel.npy -> tables/steel.json
std::filesystem::path sidecar_path(const std::filesystem::path& table);

/// Writes the sidecar of `table` in one step, without "run" if `run` is empty. Throws RunError.
void write_sidecar(const std::filesystem::path& table, const TableHeader& header,
                   const nlohmann::ordered_json& run = nlohmann::ordered_json::object());

/// The header in the sidecar of `table`; nothing if there is no such file or it is not gonio's.
/// Throws RunError if it is gonio's and broken.
std::optional<TableHeader> read_sidecar(const std::filesystem::path& table);

}  // namespace gonio

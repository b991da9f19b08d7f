// SPDX-License-Identifier: Apache-2.0
// A header as JSON: the exact form that EXR, CSV and the sidecar files carry.
// Its schema is the member "table" of tests/output/table.schema.json.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gonio/table.hpp"

namespace gonio {

/// Numbers are the shortest decimals that read back as the same double.
nlohmann::ordered_json to_json(const TableHeader& header);
nlohmann::ordered_json to_json(const Axis& axis);
nlohmann::ordered_json to_json(const Attribute& attribute);

/// The inverse of to_json. Throws RunError, beginning with `where`, if something is missing, of the
/// wrong type, or unsound (check.hpp).
TableHeader header_from_json(const nlohmann::ordered_json& json, const std::string& where);

/// One line, or `indent` spaces a level. Bytes that are not UTF-8 become the replacement character.
std::string text_of(const nlohmann::ordered_json& json, int indent = -1);

/// Throws RunError, beginning with `where`, if `text` is not JSON.
nlohmann::ordered_json parse_json(const std::string& text, const std::string& where);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Writes and reads the <stem>.json beside a table.
#include "output/sidecar.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/table_json.hpp"

namespace gonio {
namespace {

constexpr const char* format_name = "gonio table";
constexpr int format_version = 1;

std::string contents(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::filesystem::path sidecar_path(const std::filesystem::path& table)
{
    return std::filesystem::path(table).replace_extension(".json");
}

void write_sidecar(const std::filesystem::path& table, const TableHeader& header,
                   const nlohmann::ordered_json& run)
{
    nlohmann::ordered_json json = {
        {"format", format_name}, {"version", format_version}, {"table", to_json(header)}};
    if (!run.empty()) json["run"] = run;
    write_file(sidecar_path(table), text_of(json, 1) + "\n");
}

std::optional<TableHeader> read_sidecar(const std::filesystem::path& table)
{
    const auto path = sidecar_path(table);
    if (!std::filesystem::exists(path)) return std::nullopt;
    const auto text = contents(path);
    if (text.find(format_name) == std::string::npos) return std::nullopt;
    const auto json = parse_json(text, path.string());
    using Json = nlohmann::ordered_json;
    if (!json.is_object() || json.value("format", Json()) != format_name) return std::nullopt;
    if (json.value("version", Json()) != format_version) {
        throw RunError(fmt::format("{}: made by another version of gonio: \"version\" is not {}",
                                   path.string(), format_version));
    }
    return header_from_json(json.value("table", Json()), path.string());
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Reads and parses TOML files.
#include "scene/document.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

constexpr std::size_t max_file = std::size_t{16} << 20;

}  // namespace

toml::table parse_document(std::string_view text, std::string_view file)
{
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& fault) {
        const auto position = fault.source().begin;
        throw UsageError(fmt::format("{}:{}:{}: not TOML: {}", file, position.line, position.column,
                                     fault.description()));
    }
}

std::string read_document(const std::filesystem::path& path)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text(max_file + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file.eof() && file.gcount() == 0)
        throw UsageError(fmt::format("{}: cannot be read: {}", path.string(),
                                     std::generic_category().message(errno)));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_file)
        throw UsageError(fmt::format("{}: is larger than 16 MiB, which no scene and no model is",
                                     path.string()));
    return text;
}

}  // namespace gonio

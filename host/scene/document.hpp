// SPDX-License-Identifier: Apache-2.0
// TOML documents: scenes, and models of skin.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace gonio {

/// Throws UsageError with file:line:column where the text is not TOML; `file` is what messages call
/// it.
toml::table parse_document(std::string_view text, std::string_view file);

/// The text of a file of at most 16 MiB. Throws UsageError.
std::string read_document(const std::filesystem::path& path);

}  // namespace gonio

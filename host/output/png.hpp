// SPDX-License-Identifier: Apache-2.0
// Writes contact sheets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace gonio {

/// Writes an 8-bit sRGB image. rgb: 3 * width * height bytes, rows from the top, no padding.
/// The file appears in one step. Throws RunError.
void write_png(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
               std::span<const std::uint8_t> rgb);

}  // namespace gonio

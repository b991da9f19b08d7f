// SPDX-License-Identifier: Apache-2.0
// Measured reflectances.
#pragma once

#include <filesystem>
#include <string_view>

#include "skin/spectrum.hpp"

namespace gonio::skin {

/// Reads a column of reflectances as read_spectrum() does. Throws UsageError with file:line for
/// gaps of more than 20 nm, for what is no fraction, and for per cent.
Spectrum read_measured(const std::filesystem::path& path, std::string_view column);

}  // namespace gonio::skin

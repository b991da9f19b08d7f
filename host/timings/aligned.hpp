// SPDX-License-Identifier: Apache-2.0
// Text in columns.
#pragma once

#include <string>
#include <vector>

namespace gonio {

/// Lines of rows, all of as many texts, with columns as wide as the longest of theirs.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace gonio

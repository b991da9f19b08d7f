// SPDX-License-Identifier: Apache-2.0
// Text in columns.
#include "timings/aligned.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonio {

std::string aligned(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(row.size());
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k)
            text += fmt::format("{:<{}}  ", row[k], widths[k]);
        text += row.back() + '\n';
    }
    return text;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The nearest valid name for a wrong one.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "gonio/model.hpp"

namespace gonio {
namespace {

/// Insertions, deletions and substitutions between two words (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, diagonal + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace

std::string suggestion(std::string_view wrong, const std::vector<std::string_view>& candidates)
{
    if (candidates.empty()) return {};
    const auto nearest = std::ranges::min_element(
        candidates, {}, [&](std::string_view name) { return edit_distance(wrong, name); });
    if (edit_distance(wrong, *nearest) <= std::max<std::size_t>(2, wrong.size() / 3))
        return fmt::format("; did you mean `{}`?", *nearest);
    return fmt::format("; known are: {}", fmt::join(candidates, ", "));
}

}  // namespace gonio

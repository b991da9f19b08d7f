// SPDX-License-Identifier: Apache-2.0
// Two reports side by side.
#include <fmt/format.h>

#include <algorithm>

#include "timings/aligned.hpp"
#include "timings/report.hpp"

namespace gonio {
namespace {

bool apart(const Quartiles& a, const Quartiles& b)
{
    return a.high < b.low || b.high < a.low;
}

/// Quartiles of the ratio b / a, as far as those of a and b tell.
std::string ratio(const Quartiles& a, const Quartiles& b)
{
    if (a.median == b.median) return "same";
    if (!(a.low > 0)) return fmt::format("{:.3g} -> {:.3g}", a.median, b.median);
    return fmt::format("{:.3f} ({:.3f} to {:.3f}){}", b.median / a.median, b.low / a.high,
                       b.high / a.low, apart(a, b) ? " *" : "");
}

}  // namespace

std::string comparison(const BenchReport& first, const BenchReport& second)
{
    std::string text = "second / first; in brackets from the quartiles of both; * beyond them\n";
    for (const char* key : {"program", "device", "driver", "width", "cxx", "noise"})
        text += fmt::format("{:<8} {}\n{:<8} {}\n", key,
                            first.about.value(key, nlohmann::ordered_json()).dump(), "",
                            second.about.value(key, nlohmann::ordered_json()).dump());
    for (const BenchPlot& plot : first.plots) {
        const auto other = std::ranges::find(second.plots, plot.id, &BenchPlot::id);
        if (other == second.plots.end()) continue;
        std::vector<std::vector<std::string>> rows{{"", "", plot.x_title, plot.y_title}};
        for (const BenchPoint& point : plot.points) {
            const auto twin = std::ranges::find_if(other->points, [&](const BenchPoint& p) {
                return p.series == point.series && p.label == point.label;
            });
            if (twin == other->points.end()) continue;
            rows.push_back(
                {point.series, point.label, ratio(point.x, twin->x), ratio(point.y, twin->y)});
        }
        text += fmt::format("\n{}\n{}", plot.title, aligned(rows));
    }
    return text;
}

}  // namespace gonio

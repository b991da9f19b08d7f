// SPDX-License-Identifier: Apache-2.0
// Puts axes, rows, columns and texels into words.
#include "output/conventions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace gonio {
namespace {

constexpr double even_tolerance = 1e-9;  // of the axis' extent

bool all_are(const TableHeader& header, Samples samples)
{
    for (std::size_t a = header.sweep_axes; a < header.axes.size(); ++a) {
        if (header.axes[a].samples != samples) return false;
    }
    return true;
}

}  // namespace

bool is_evenly_spaced(const Axis& axis)
{
    const auto& values = axis.values;
    const double extent = values.back() - values.front();
    for (std::size_t k = 1; k + 1 < values.size(); ++k) {
        const double even = values.front() + extent * static_cast<double>(k) /
                                                 static_cast<double>(values.size() - 1);
        if (std::abs(values[k] - even) > even_tolerance * std::abs(extent)) return false;
    }
    return true;
}

std::string axis_text(const Axis& axis)
{
    const auto kind = axis.samples == Samples::centre ? "cell centre" : "node";
    const auto unit = axis.unit.empty() || axis.unit == "1" ? "" : " " + axis.unit;
    const auto& values = axis.values;
    if (values.size() == 1) return fmt::format("1 {} at {}{}", kind, values.front(), unit);
    if (is_evenly_spaced(axis)) {
        return fmt::format("{} {}s, evenly spaced from {} to {}{}", values.size(), kind,
                           values.front(), values.back(), unit);
    }
    return fmt::format("{} {}s at {}{}", values.size(), kind, fmt::join(values, " "), unit);
}

std::string rows_text(const TableHeader& header)
{
    std::vector<std::string> names;
    for (std::size_t a = header.sweep_axes; a + 1 < header.axes.size(); ++a) {
        names.push_back(header.axes[a].name);
    }
    if (names.empty()) return "one row";
    if (names.size() > 1) names.front() += " (outer)";
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string columns_text(const TableHeader& header)
{
    return header.axes.empty() ? "one column" : header.axes.back().name;
}

std::string texels_text(const TableHeader& header)
{
    if (all_are(header, Samples::centre)) {
        return "texel k of n is the sample at the centre of cell k: its texture coordinate is "
               "(k + 0.5)/n";
    }
    if (all_are(header, Samples::node)) {
        return "texel k of n is the sample at node k, texels 0 and n - 1 at the end points: node k "
               "has the texture coordinate (k + 0.5)/n";
    }
    return "texel k of n is sample k of its axis, at a cell centre or a node as the axis says: its "
           "texture coordinate is (k + 0.5)/n";
}

}  // namespace gonio

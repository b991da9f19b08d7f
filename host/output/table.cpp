// SPDX-License-Identifier: Apache-2.0
// What a header knows about itself: sizes, attributes, and whether it is sound.
#include "gonio/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "gonio/errors.hpp"
#include "output/check.hpp"

namespace gonio {
namespace {

UsageError too_large(const TableHeader& header)
{
    return UsageError(
        fmt::format("a table of {} cells is larger than can be addressed", shape_text(header)));
}

std::size_t product(const TableHeader& header, std::size_t axes)
{
    std::size_t count = 1;
    for (std::size_t a = 0; a < axes; ++a) {
        if (__builtin_mul_overflow(count, header.axes[a].values.size(), &count)) {
            throw too_large(header);
        }
    }
    return count;
}

void check_text(const std::string& text, const std::string& what)
{
    const auto is_bad = [](unsigned char c) { return c == ',' || c == '"' || std::iscntrl(c); };
    if (std::any_of(text.begin(), text.end(), is_bad)) {
        throw UsageError(
            fmt::format("{} '{}' holds a comma, a quote or a control character", what, text));
    }
}

void check_name(const std::string& name, const std::string& what, std::set<std::string>& seen)
{
    if (name.empty()) throw UsageError(fmt::format("a table has {} without a name", what));
    check_text(name, what);
    if (!seen.insert(name).second) {
        throw UsageError(fmt::format("a table has two of {} '{}'", what, name));
    }
}

bool all_finite(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool is_strictly_monotonic(const std::vector<double>& values)
{
    const auto no_pair = [&](auto breaks_order) {
        return std::adjacent_find(values.begin(), values.end(), breaks_order) == values.end();
    };
    return no_pair(std::greater_equal<>()) || no_pair(std::less_equal<>());
}

void check_axis(const Axis& axis)
{
    check_text(axis.unit, "the unit");
    if (axis.values.empty()) throw UsageError(fmt::format("axis '{}' is empty", axis.name));
    if (!all_finite(axis.values) || !is_strictly_monotonic(axis.values)) {
        throw UsageError(fmt::format("axis '{}' is not finite and strictly monotonic", axis.name));
    }
}

void check_attribute(const std::string& name, const Attribute& attribute)
{
    const auto* number = std::get_if<double>(&attribute);
    const auto* list = std::get_if<std::vector<double>>(&attribute);
    if ((number && !std::isfinite(*number)) || (list && !all_finite(*list))) {
        throw UsageError(fmt::format("attribute '{}' is not finite", name));
    }
}

}  // namespace

std::size_t TableHeader::row_length() const
{
    return axes.empty() ? 1 : axes.back().values.size();
}

std::size_t TableHeader::rows() const
{
    return product(*this, axes.empty() ? 0 : axes.size() - 1);
}

std::size_t TableHeader::cells() const
{
    return product(*this, axes.size());
}

const Attribute* TableHeader::find(const std::string& name) const
{
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    return found == attributes.end() ? nullptr : &found->second;
}

std::string shape_text(const TableHeader& header)
{
    std::vector<std::size_t> shape;
    for (const auto& axis : header.axes) shape.push_back(axis.values.size());
    return fmt::format("{}", fmt::join(shape, " x "));
}

void check(const TableHeader& header)
{
    check_text(header.unit, "the unit");
    std::set<std::string> names;
    check_name(header.quantity, "the quantity", names);
    names.clear();
    for (const auto& axis : header.axes) check_name(axis.name, "the axis", names);
    for (const auto& channel : header.channels) check_name(channel, "the channel", names);
    for (const auto& axis : header.axes) check_axis(axis);
    if (header.channels.empty()) throw UsageError("a table has no channel");
    if (header.sweep_axes > 0 && header.sweep_axes >= header.axes.size()) {
        throw UsageError("a table has no axis besides the swept ones");
    }
    names.clear();
    for (const auto& [name, attribute] : header.attributes) {
        check_name(name, "the attribute", names);
        check_attribute(name, attribute);
    }
    std::size_t bytes = 0;
    if (__builtin_mul_overflow(header.cells(), header.channels.size() * sizeof(double), &bytes)) {
        throw too_large(header);
    }
}

}  // namespace gonio

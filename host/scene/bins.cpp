// SPDX-License-Identifier: Apache-2.0
// Checks the axes of a table against those of its quantity.
#include "scene/bins.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gonio {
namespace {

constexpr double even_tolerance = 1e-9;  // of a bin

std::string wanted_axes(const Quantity& quantity)
{
    std::string text;
    for (const auto& [name, unit] : quantity.axes)
        text += fmt::format("{}{} = {{ {} }}", text.empty() ? "" : ", ", name,
                            unit == "nm"
                                ? "values = [400, 410, …]"
                                : fmt::format("to = {}, count = …", unit == "deg" ? "90" : "…"));
    return fmt::format("axes = {{ {} }}", text);
}

/// Bins are even, begin at 0, and angles end at 90 degrees.
void check_bins(const Value& where, const Axis& axis)
{
    const double width = 2 * axis.values.front();
    const double end = width * static_cast<double>(axis.values.size());
    const double last = axis.values.back() + axis.values.front();
    if (axis.samples != Samples::centre || !(width > 0) ||
        std::abs(last - end) > even_tolerance * end)
        where.fail(fmt::format("the bins of `{}` must be even, from 0 on", axis.name));
    if (axis.unit == "deg" && std::abs(end - 90) > even_tolerance * 90)
        where.fail(fmt::format("the angles of `{}` must end at 90 deg, not at {}", axis.name, end));
}

}  // namespace

void name_axes(const Value& axes, TableRequest& request)
{
    const Quantity& quantity = *request.quantity;
    bool fit = request.axes.size() == quantity.axes.size();
    for (std::size_t k = 0; fit && k < quantity.axes.size(); ++k)
        fit = request.axes[k].name == quantity.axes[k].name;
    if (!fit)
        axes.fail(fmt::format("the quantity `{}` needs {}", quantity.id, wanted_axes(quantity)));
    for (std::size_t k = 0; k < quantity.axes.size(); ++k)
        request.axes[k].unit = quantity.axes[k].unit;
}

void read_bins(const Section& table, TableRequest& request)
{
    if (request.quantity->axes.empty()) {
        if (const auto axes = table.find("axes"))
            axes->fail(fmt::format("the quantity `{}` has no axes", request.quantity->id));
        return;
    }
    const Value axes = table.at("axes");
    name_axes(axes, request);
    for (const Axis& axis : request.axes)
        if (axis.unit != "nm") check_bins(axes, axis);
}

}  // namespace gonio

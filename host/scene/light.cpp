// SPDX-License-Identifier: Apache-2.0
// Reads what a table of layers asks for: how they are lit, and over which bins.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "scene/table.hpp"

namespace gonio {
namespace {

constexpr double even_tolerance = 1e-9;  // of a bin

std::string wanted_axes(const Quantity& quantity)
{
    std::string text;
    for (const auto& [name, unit] : quantity.axes)
        text += fmt::format("{}{} = {{ to = {}, count = … }}", text.empty() ? "" : ", ", name,
                            unit == "deg" ? "90" : "…");
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

void read_bins(const Section& table, TableRequest& request)
{
    const Quantity& quantity = *request.quantity;
    if (quantity.axes.empty()) {
        if (const auto axes = table.find("axes"))
            axes->fail(fmt::format("the quantity `{}` has no axes", quantity.id));
        return;
    }
    const Value axes = table.at("axes");
    bool fit = request.axes.size() == quantity.axes.size();
    for (std::size_t k = 0; fit && k < quantity.axes.size(); ++k)
        fit = request.axes[k].name == quantity.axes[k].name;
    if (!fit)
        axes.fail(fmt::format("the quantity `{}` needs {}", quantity.id, wanted_axes(quantity)));
    for (std::size_t k = 0; k < quantity.axes.size(); ++k) {
        request.axes[k].unit = quantity.axes[k].unit;
        check_bins(axes, request.axes[k]);
    }
}

}  // namespace

void read_light_request(const Section& table, TableRequest& request)
{
    if (const auto grid = table.find("grid"))
        grid->fail(fmt::format("the quantity `{}` has no `grid`", request.quantity->id));
    if (const auto light = table.find("light"))
        request.light.diffuse = light->choice({"beam", "diffuse"}) == 1;
    if (const auto theta = table.find("theta_i")) {
        if (request.light.diffuse) theta->fail("`theta_i` is for a beam, not for diffuse light");
        const double below_90 = std::nextafter(90.0, 0.0);
        request.light.incidence = theta->number(0, below_90) * std::numbers::pi / 180;
    }
    if (const auto seed = table.find("seed"))
        request.seed = seed->count(0, std::numeric_limits<std::int64_t>::max());
    read_bins(table, request);
    if (request.solver != "adding_doubling") return;
    for (const auto key : {"time", "photons", "seed"})
        if (const auto value = table.find(key))
            value->fail(
                fmt::format("`{}` is for solver = \"monte_carlo\", not adding_doubling, "
                            "which has no noise",
                            key));
}

}  // namespace gonio

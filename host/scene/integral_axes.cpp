// SPDX-License-Identifier: Apache-2.0
// Reads the axes of an integral over the hemisphere.
#include "plan/integral_axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gonio/model.hpp"
#include "plan/lobe_names.hpp"
#include "scene/document.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

constexpr double least_cosine = 1e-6, greatest_angle = 89.9999;

void check_direction(const Value& entry, DirectionAxis kind, const Axis& axis)
{
    const auto [least, greatest] = std::ranges::minmax(axis.values);
    const bool cosine = kind == DirectionAxis::cosine || kind == DirectionAxis::other_cosine;
    if (cosine && !(least >= least_cosine && greatest <= 1))
        entry.fail(
            fmt::format("`{}` is from {} to {}; allowed is {} to 1, the cosine to the normal",
                        axis.name, least, greatest, least_cosine));
    if (kind == DirectionAxis::angle && !(least >= 0 && greatest <= greatest_angle))
        entry.fail(fmt::format("`{}` is from {} to {}; allowed is 0 to {} deg", axis.name, least,
                               greatest, greatest_angle));
}

void check_parameter(const Value& entry, std::vector<Lobe> lobes, const Sweep& parameter,
                     const Axis& axis)
{
    located(entry.where(), [&] {
        for (const double value : axis.values)
            lobes[parameter.part].set(parameter.parameter, std::vector{value});
    });
}

/// All that can be an axis, for the nearest name.
std::vector<std::string> known_names(const Quantity& quantity, const std::vector<Lobe>& lobes)
{
    std::vector<std::string> names;
    for (const auto& [name, kind] : direction_axes(quantity)) names.emplace_back(name);
    const auto prefixes = lobe_prefixes(lobes);
    for (std::size_t part = 0; part < lobes.size(); ++part) {
        for (const Parameter& parameter : lobes[part].model->parameters)
            if (parameter.is_number())
                names.push_back(prefixes[part] + std::string(parameter.name));
        for (const Both& both : lobes[part].model->both)
            names.push_back(prefixes[part] + std::string(both.alias));
    }
    return names;
}

}  // namespace

void read_integral_axes(const Value& axes, const SceneMaterial& material, TableRequest& request)
{
    const auto& lobes = std::get<std::vector<Lobe>>(material.made_of);
    const auto directions = direction_axes(*request.quantity);
    request.axes = read_axes(axes);
    const auto entries = Section(axes).values();
    for (std::size_t k = 0; k < entries.size(); ++k) {
        Axis& axis = request.axes[k];
        const auto named =
            std::ranges::find(directions, axis.name, [](const auto& entry) { return entry.first; });
        if (named != directions.end()) {
            check_direction(entries[k], named->second, axis);
            const bool angle = axis.name.starts_with("theta") || axis.name.starts_with("phi");
            axis.unit = angle ? "deg" : "1";
            continue;
        }
        auto parameter = parameter_of(lobes, axis.name);
        if (!parameter) {
            const auto known = known_names(*request.quantity, lobes);
            entries[k].fail(fmt::format("`{}` is no axis of the quantity `{}`{}", axis.name,
                                        request.quantity->id,
                                        suggestion(axis.name, {known.begin(), known.end()})));
        }
        check_parameter(entries[k], lobes, *parameter, axis);
        parameter->values = axis.values;
        axis.unit = sweep_axis(*parameter, lobes).unit;
    }
    for (const Quantity::AxisName& needed : request.quantity->axes) {
        const auto is_direction = [&](const Axis& axis) {
            return axis.name == needed.name ||
                   (needed.name == "mu" && axis.name.starts_with("theta"));
        };
        if (std::ranges::count_if(request.axes, is_direction) != 1)
            axes.fail(fmt::format("the quantity `{}` needs one axis `{}`", request.quantity->id,
                                  needed.name));
    }
}

void read_integral_axes(const std::vector<std::string>& lines, const SceneMaterial& material,
                        TableRequest& request)
{
    const toml::table document =
        parse_document(fmt::format("{}", fmt::join(lines, "\n")), "--axis");
    read_integral_axes(Value(document, "--axis", document.source().begin), material, request);
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What the axes of an integral over the hemisphere mean.
#include "plan/integral_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gonio/errors.hpp"
#include "grid/angles.hpp"
#include "plan/lobe_names.hpp"

namespace gonio {
namespace {

constexpr std::size_t max_cells = std::size_t{1} << 24;

/// An axis with what its values set.
struct Setting {
    const std::vector<double>* values;
    std::optional<DirectionAxis> direction;
    std::optional<Sweep> parameter;
};

void point(IntegralCell& cell, DirectionAxis axis, double value)
{
    if (axis == DirectionAxis::cosine) cell.at.cosine = value;
    if (axis == DirectionAxis::angle) cell.at.cosine = cosine_of_degrees(value);
    if (axis == DirectionAxis::azimuth) cell.at.phi = value;
    if (axis == DirectionAxis::other_cosine) cell.other_cosine = value;
}

}  // namespace

std::vector<std::pair<std::string_view, DirectionAxis>> direction_axes(const Quantity& quantity)
{
    using enum DirectionAxis;
    std::vector<std::pair<std::string_view, DirectionAxis>> names;
    for (const Quantity::AxisName& axis : quantity.axes) {
        if (axis.name == "mu_i") names.emplace_back("mu_i", cosine);
        if (axis.name == "mu_o") names.emplace_back("mu_o", other_cosine);
        if (axis.name != "mu") continue;
        const bool light =
            quantity.id == "directional_albedo" || quantity.id == "specular_reflectance";
        names = {{"mu", cosine},
                 {light ? "theta_i" : "theta_o", angle},
                 {light ? "phi_i" : "phi_o", azimuth}};
    }
    return names;
}

std::optional<Sweep> parameter_of(const std::vector<Lobe>& lobes, std::string_view name)
{
    const auto prefixes = lobe_prefixes(lobes);
    for (std::size_t part = 0; part < lobes.size(); ++part) {
        if (!name.starts_with(prefixes[part])) continue;
        const std::string parameter(name.substr(prefixes[part].size()));
        const Model& model = *lobes[part].model;
        const std::size_t index = model.index_of(parameter);
        const bool number = index != Model::npos && model.parameters[index].is_number();
        const bool both =
            std::ranges::find(model.both, parameter, &Both::alias) != model.both.end();
        if (number || both || parameter == "weight") return Sweep{part, parameter, {}, true, {}};
    }
    return {};
}

void fill_integral(Job& job, const TableRequest& request, const std::vector<Lobe>& lobes,
                   const std::vector<Sweep>& sweeps)
{
    std::vector<Setting> settings;
    for (const Sweep& sweep : sweeps) settings.push_back({&sweep.values, {}, sweep});
    const auto directions = direction_axes(*request.quantity);
    for (const Axis& axis : request.axes) {
        const auto named =
            std::ranges::find(directions, axis.name, [](const auto& entry) { return entry.first; });
        if (named != directions.end())
            settings.push_back({&axis.values, named->second, {}});
        else
            settings.push_back({&axis.values, {}, parameter_of(lobes, axis.name)});
    }
    std::size_t count = 1, materials = 1;
    for (const Setting& setting : settings) {
        count *= setting.values->size();
        if (count > max_cells)
            throw UsageError(
                fmt::format("{}a table of more than {} integrals", request.where, max_cells));
        if (setting.parameter) materials *= setting.values->size();
    }
    job.cells.resize(count);
    job.materials.assign(materials, {job.name, lobes});
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t stride = count;
        IntegralCell& cell = job.cells[k];
        for (const Setting& setting : settings) {
            stride /= setting.values->size();
            const std::size_t at = k / stride % setting.values->size();
            if (setting.parameter) cell.material = cell.material * setting.values->size() + at;
            if (setting.direction) point(cell, *setting.direction, (*setting.values)[at]);
        }
        Material& material = job.materials[cell.material];
        stride = count;
        for (const Setting& setting : settings) {
            stride /= setting.values->size();
            const std::size_t at = k / stride % setting.values->size();
            if (setting.parameter)
                material.lobes[setting.parameter->part].set(setting.parameter->parameter,
                                                            std::vector{(*setting.values)[at]});
        }
    }
    job.seconds = request.budget.seconds;
    job.max_error = request.budget.max_error.value_or(job.seconds ? 0 : job.max_error);
    job.must_reach = request.budget.max_error.has_value();
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// How much light a model reflects at most.
#include "verify/gain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "gonio/albedo.hpp"
#include "verify/cases.hpp"

namespace gonio {
namespace {

constexpr std::array cosines{1.0, 0.7, 0.4, 0.2, 0.1, 0.05, 0.02, 0.01};
constexpr int steps = 7;
constexpr double max_error = 1e-3;

bool is_reflectance(const Parameter& parameter)
{
    return parameter.kind == Kind::color && parameter.least == 0 && parameter.greatest == 1;
}

/// Both ends and what lies between, in even steps, or even ratios where it spans more than two
/// decades.
std::vector<double> values_of(const Parameter& parameter)
{
    const double least = parameter.least, greatest = parameter.greatest;
    const bool ratios =
        greatest > 100 * std::max(least, 1.0) || (least > 0 && greatest > 100 * least);
    const double low = least > 0 ? least : 0.1;
    std::vector<double> values{least, parameter.preset, greatest};
    for (int k = 1; k + 1 < steps; ++k) {
        const double part = static_cast<double>(k) / (steps - 1);
        values.push_back(ratios ? low * std::pow(greatest / low, part)
                                : least + (greatest - least) * part);
    }
    return values;
}

/// The names that are varied: those that set two numbers, and the scalars that are left.
std::vector<std::pair<std::string_view, const Parameter*>> varied(const Model& model)
{
    std::vector<std::pair<std::string_view, const Parameter*>> names;
    for (const Parameter& parameter : model.parameters) {
        if (parameter.kind != Kind::scalar || parameter.unit == "nm") continue;
        std::string_view name = parameter.name;
        bool is_second = false;
        for (const Both& both : model.both) {
            if (both.first == name) name = both.alias;
            is_second = is_second || both.second == parameter.name;
        }
        if (!is_second) names.emplace_back(name, &parameter);
    }
    return names;
}

/// A variant with every combination of its numbers.
std::vector<Material> materials_of(Lobe lobe)
{
    const Model& model = *lobe.model;
    for (const Parameter& parameter : model.parameters)
        if (is_reflectance(parameter)) lobe.set(parameter.name, std::vector{1.0});
    std::vector<Material> all{{std::string(model.id), {lobe}}};
    for (const auto& [name, parameter] : varied(model)) {
        std::vector<Material> more;
        for (const Material& material : all)
            for (const double value : values_of(*parameter)) {
                more.push_back(material);
                more.back().lobes[0].set(name, std::vector{value});
            }
        all = std::move(more);
    }
    return all;
}

std::string where(const Lobe& lobe, double cosine)
{
    std::string text = fmt::format("n.l = {}", cosine);
    for (std::size_t k = 0; k < lobe.values.size(); ++k) {
        const Parameter& parameter = lobe.model->parameters[k];
        const double value = lobe.values[k][0];
        if (value == parameter.preset || is_reflectance(parameter)) continue;
        if (parameter.kind == Kind::choice)
            text += fmt::format(", {} = {}", parameter.name,
                                parameter.options[static_cast<std::size_t>(value)].name);
        else
            text += fmt::format(", {} = {:.4g}", parameter.name, value);
    }
    return text;
}

}  // namespace

Gain largest_albedo(const Device& device, const Model& model)
{
    Gain largest;
    for (const Lobe& variant : single_variants(model)) {
        const std::vector<Material> materials = materials_of(variant);
        std::vector<AlbedoCell> cells;
        for (std::size_t m = 0; m < materials.size(); ++m)
            for (const double cosine : cosines) cells.push_back({m, {cosine, 0}});
        const Albedos found =
            integrate_albedos(device, materials, cells, {Fixed::light, max_error});
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double value = found.value[0][k], error = found.error[0][k];
            if (!(value > largest.albedo) || !(error < 0.01 * value)) continue;
            largest = {value, error,
                       where(materials[cells[k].material].lobes[0], cells[k].at.cosine)};
        }
    }
    return largest;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// A model of skin with numbers for its parameters.
#include "gonio/skin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gonio/errors.hpp"
#include "gonio/model.hpp"
#include "scene/located.hpp"
#include "skin/recipe.hpp"

namespace gonio {

std::size_t SkinModel::index_of(std::string_view parameter) const
{
    const auto found = std::ranges::find(parameters, parameter, &SkinParameter::name);
    if (found != parameters.end()) return static_cast<std::size_t>(found - parameters.begin());
    std::vector<std::string_view> names;
    for (const SkinParameter& each : parameters) names.push_back(each.name);
    throw UsageError(fmt::format("skin `{}` has no parameter `{}`{}", id, parameter,
                                 suggestion(parameter, names)));
}

Skin::Skin(SkinModel model) : model_(std::move(model))
{
    for (const SkinParameter& parameter : model_.parameters) values_.push_back(parameter.preset);
}

void Skin::set(std::string_view parameter, double value)
{
    const std::size_t index = model_.index_of(parameter);
    const SkinParameter& range = model_.parameters[index];
    if (!(value >= range.least && value <= range.greatest))
        throw UsageError(fmt::format("`{}` is {}; allowed is {} to {}{}", range.name, value,
                                     range.least, range.greatest,
                                     range.unit == "1" ? "" : " " + range.unit));
    values_[index] = value;
}

double Skin::least_wavelength() const
{
    return model_.recipe->least_wavelength;
}

double Skin::greatest_wavelength() const
{
    return model_.recipe->greatest_wavelength;
}

LayeredMedium Skin::layers_at(double wavelength) const
{
    const skin::Recipe& recipe = *model_.recipe;
    if (!(wavelength >= recipe.least_wavelength && wavelength <= recipe.greatest_wavelength)) {
        const std::string& by =
            wavelength < recipe.least_wavelength ? recipe.least_by : recipe.greatest_by;
        throw UsageError(fmt::format("{} nm: skin `{}` is known at {} to {} nm{}", wavelength,
                                     model_.id, recipe.least_wavelength, recipe.greatest_wavelength,
                                     by.empty() ? "" : fmt::format("; so far goes `{}`", by)));
    }
    LayeredMedium medium = recipe.around;
    for (const skin::LayerRecipe& layer : recipe.layers)
        medium.layers.push_back(layer.at(wavelength, values_));
    located(recipe.where, [&] { validate(medium); });
    return medium;
}

}  // namespace gonio

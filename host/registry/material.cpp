// SPDX-License-Identifier: Apache-2.0
// Lobes and materials: setting parameters with validation, and what follows from them.
#include "gonio/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

std::vector<std::string_view> parameter_names(const Model& model)
{
    std::vector<std::string_view> names{"weight"};
    for (const Parameter& parameter : model.parameters) names.push_back(parameter.name);
    for (const Both& both : model.both) names.push_back(both.alias);
    return names;
}

std::size_t index_or_throw(const Model& model, std::string_view name)
{
    const std::size_t index = model.index_of(name);
    if (index == Model::npos)
        throw UsageError(fmt::format("model `{}` has no parameter `{}`{}", model.id, name,
                                     suggestion(name, parameter_names(model))));
    return index;
}

void check_range(std::string_view name, std::string_view unit, double least, double greatest,
                 const std::vector<double>& numbers)
{
    for (const double number : numbers)
        if (!(number >= least && number <= greatest))
            throw UsageError(fmt::format("`{}` is {}; allowed is {} to {}{}", name, number, least,
                                         greatest, unit == "1" ? "" : fmt::format(" {}", unit)));
}

void check_channels(std::string_view name, const std::vector<double>& numbers)
{
    if (numbers.empty() || numbers.size() > max_channels)
        throw UsageError(
            fmt::format("`{}` has {} numbers; allowed is one, or one for each of up to {} channels",
                        name, numbers.size(), max_channels));
}

}  // namespace

void Lobe::set(std::string_view name, const std::vector<double>& numbers)
{
    if (name == "weight") {
        check_channels(name, numbers);
        check_range(name, "1", 0, 1e6, numbers);
        weight = numbers;
        return;
    }
    const auto both = std::ranges::find(model->both, name, &Both::alias);
    if (both != model->both.end()) {
        set(both->first, numbers);
        set(both->second, numbers);
        return;
    }
    const std::size_t index = index_or_throw(*model, name);
    const Parameter& parameter = model->parameters[index];
    if (!parameter.is_number())
        throw UsageError(
            fmt::format("`{}` is {}, not a number", name,
                        parameter.kind == Kind::choice ? "a choice by name" : "read from a file"));
    if (parameter.kind == Kind::scalar && numbers.size() != 1)
        throw UsageError(fmt::format("`{}` is one number, not {}", name, numbers.size()));
    check_channels(name, numbers);
    check_range(name, parameter.unit, parameter.least, parameter.greatest, numbers);
    values[index] = numbers;
}

void Lobe::set(std::string_view name, std::string_view option)
{
    const std::size_t index = index_or_throw(*model, name);
    const Parameter& parameter = model->parameters[index];
    if (parameter.kind == Kind::table) {
        const auto grid = std::make_shared<const ResidualGrid>(read_residual(option));
        for (const auto& [given, numbers] : grid->parameters) set(given, numbers);
        tables.resize(values.size());
        tables[index] = grid;
        return;
    }
    if (parameter.kind != Kind::choice)
        throw UsageError(fmt::format("`{}` is a number, not \"{}\"", name, option));
    const auto found = std::ranges::find(parameter.options, option, &Option::name);
    if (found == parameter.options.end()) {
        std::vector<std::string_view> names;
        for (const Option& known : parameter.options) names.push_back(known.name);
        throw UsageError(
            fmt::format("`{}` has no option `{}`{}", name, option, suggestion(option, names)));
    }
    values[index] = {static_cast<double>(found - parameter.options.begin())};
}

unsigned Lobe::traits() const
{
    unsigned all = model->traits;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (model->parameters[k].kind == Kind::choice)
            all |= model->parameters[k].options[static_cast<std::size_t>(values[k][0])].traits;
    return all;
}

bool Lobe::isotropic() const
{
    const auto agree = [this](const Both& both) {
        return values[model->index_of(both.first)] == values[model->index_of(both.second)];
    };
    const auto is_there = [this](const ParameterAt& at) {
        return values[model->index_of(at.name)] == std::vector{at.number};
    };
    return std::ranges::all_of(model->both, agree) &&
           std::ranges::all_of(model->isotropic_at, is_there);
}

std::size_t Lobe::channels() const
{
    std::size_t count = weight.size();
    for (const auto& numbers : values) count = std::max(count, numbers.size());
    for (const auto& grid : tables)
        if (grid) count = std::max(count, grid->channels);
    return count;
}

std::shared_ptr<const ResidualGrid> Lobe::table(std::size_t parameter) const
{
    return parameter < tables.size() ? tables[parameter] : nullptr;
}

double Lobe::number(std::size_t parameter, std::size_t channel) const
{
    const auto& numbers = values[parameter];
    const double outside = numbers[numbers.size() == 1 ? 0 : channel];
    const bool degrees = model->parameters[parameter].unit == "deg";
    return degrees ? outside * std::numbers::pi / 180 : outside;
}

Lobe default_lobe(std::string_view name)
{
    const auto alias = std::ranges::find(aliases(), name, &Alias::name);
    const Model* model = find_model(alias == aliases().end() ? name : alias->model);
    if (model == nullptr) {
        std::vector<std::string_view> names;
        for (const Model& known : models()) names.push_back(known.id);
        for (const Alias& known : aliases()) names.push_back(known.name);
        throw UsageError(fmt::format("there is no model `{}`{}", name, suggestion(name, names)));
    }
    Lobe lobe{model, {}, {1.0}};
    for (const Parameter& parameter : model->parameters) lobe.values.push_back({parameter.preset});
    if (alias != aliases().end() && !alias->choice.empty()) lobe.set(alias->choice, alias->option);
    return lobe;
}

bool Material::isotropic() const
{
    return std::ranges::all_of(lobes, &Lobe::isotropic);
}

std::size_t Material::channels() const
{
    std::size_t count = 1;
    for (const Lobe& lobe : lobes) count = std::max(count, lobe.channels());
    for (const Lobe& lobe : lobes)
        for (const auto& grid : lobe.tables)
            if (grid && grid->channels != 1 && grid->channels != count)
                throw UsageError(fmt::format("{} has {} channels where the material has {}",
                                             grid->name, grid->channels, count));
    for (const Lobe& lobe : lobes)
        for (std::size_t k = 0; k <= lobe.values.size(); ++k) {
            const auto& numbers = k < lobe.values.size() ? lobe.values[k] : lobe.weight;
            if (numbers.size() != 1 && numbers.size() != count)
                throw UsageError(
                    fmt::format("`{}` has {} numbers where the material has {} channels",
                                k < lobe.values.size() ? lobe.model->parameters[k].name : "weight",
                                numbers.size(), count));
        }
    return count;
}

std::vector<std::string> Material::channel_names() const
{
    const std::size_t count = channels();
    if (count == 1) return {"Y"};
    const std::vector<std::string> all{"R", "G", "B", "A"};
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace gonio

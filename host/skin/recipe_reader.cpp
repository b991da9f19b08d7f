// SPDX-License-Identifier: Apache-2.0
// Numbers and laws of a model of skin.
#include "skin/recipe_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gonio/model.hpp"

namespace gonio::skin {

RecipeReader::RecipeReader(const std::vector<SkinParameter>& parameters,
                           std::vector<Section> places, std::filesystem::path folder)
    : parameters_(parameters),
      places_(std::move(places)),
      folder_(std::move(folder)),
      used_(parameters.size())
{
}

std::optional<std::size_t> RecipeReader::find_parameter(const std::string& name)
{
    const auto found = std::ranges::find(parameters_, name, &SkinParameter::name);
    if (found == parameters_.end()) return std::nullopt;
    const auto index = static_cast<std::size_t>(found - parameters_.begin());
    used_[index] = true;
    return index;
}

/// What the first place that has it calls so: `kind` is "laws" or "substances".
std::optional<Value> RecipeReader::find(std::string_view kind, const std::string& name) const
{
    for (const Section& place : places_)
        if (const auto all = place.find(kind))
            if (auto value = Section(*all).find(name)) return value;
    return std::nullopt;
}

std::vector<std::string> RecipeReader::names_of(std::string_view kind) const
{
    std::vector<std::string> names;
    for (const Section& place : places_)
        if (const auto all = place.find(kind))
            for (const Value& value : Section(*all).values()) names.push_back(value.name());
    return names;
}

Amount RecipeReader::factor(const Value& value)
{
    if (!value.is_text()) return {value.number()};
    if (const auto parameter = find_parameter(value.text())) return {1, {*parameter}};
    std::vector<std::string_view> names;
    for (const SkinParameter& parameter : parameters_) names.push_back(parameter.name);
    value.fail(
        fmt::format("there is no parameter `{}`{}", value.text(), suggestion(value.text(), names)));
}

Amount RecipeReader::amount(const Value& value)
{
    if (!value.is_list()) return factor(value);
    Amount product;
    for (const Value& each : value.list()) product = product * factor(each);
    return product;
}

Term RecipeReader::term(const Value& value)
{
    const Section section(value);
    section.allow({"scale", "power", "reference", "from", "decay"});
    Term term{.scale = amount(section.at("scale"))};
    const auto power = section.find("power"), decay = section.find("decay");
    if (power && decay) decay->fail("a term has a `power` or a `decay`, not both");
    if (power) term.power = amount(*power);
    if (const auto reference = section.find("reference")) {
        if (!power) reference->fail("`reference` is for a term with a `power`");
        term.reference = reference->number(1e-3, 1e6);
    }
    if (const auto from = section.find("from")) {
        if (!decay) from->fail("`from` is for a term with a `decay`");
        term.from = from->number();
    }
    if (decay) term.decay = decay->number(1e-3, 1e6);
    return term;
}

Law RecipeReader::terms(const Value& value)
{
    Law law;
    for (const Value& each : value.list()) law.terms.push_back(term(each));
    return law;
}

Law RecipeReader::law(const Value& value)
{
    if (value.is_number()) return {{Term{.scale = {value.number()}}}};
    if (value.is_list()) return terms(value);
    if (value.is_table()) {
        const Section section(value);
        section.allow({"law", "scale"});
        return law(section.at("law")).scaled(amount(section.at("scale")));
    }
    const std::string name = value.text();
    const auto known = find("laws", name);
    if (const auto parameter = find_parameter(name)) {
        if (known) value.fail(fmt::format("`{}` is a parameter and a law; rename one", name));
        return {{Term{.scale = {1, {*parameter}}}}};
    }
    if (known) return terms(*known);
    auto names = names_of("laws");
    for (const SkinParameter& parameter : parameters_) names.push_back(parameter.name);
    value.fail(fmt::format("there is no law and no parameter `{}`{}", name,
                           suggestion(name, {names.begin(), names.end()})));
}

}  // namespace gonio::skin

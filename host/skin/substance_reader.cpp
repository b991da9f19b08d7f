// SPDX-License-Identifier: Apache-2.0
// Substances of a model of skin.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "gonio/model.hpp"
#include "scene/located.hpp"
#include "skin/recipe_reader.hpp"

namespace gonio::skin {
namespace {

/// The spectrum beside the model's file, or else the one that is built in.
Spectrum open_spectrum(const Value& file, const std::filesystem::path& folder,
                       const std::string& column)
{
    const std::filesystem::path path = folder / file.text();
    std::ifstream stream;
    if (!folder.empty()) stream.open(path);
    if (!stream.is_open() && !find_data("skin/" + file.text()))
        file.fail(fmt::format("there is no spectrum `{}`, neither beside the model nor built in",
                              file.text()));
    return located(file.where(), [&] {
        return stream.is_open() ? read_spectrum(stream, path.string(), column)
                                : built_in_spectrum("skin/" + file.text(), column);
    });
}

}  // namespace

std::shared_ptr<const Substance> RecipeReader::substance(const Value& value)
{
    if (value.is_text()) return named(value, value.text());
    if (!value.is_number()) return read(value);
    Substance constant{.law = {{Term{.scale = {value.number(0)}}}}, .where = value.where()};
    return std::make_shared<const Substance>(std::move(constant));
}

RecipeReader::Named RecipeReader::named(const Value& user, const std::string& name)
{
    if (const auto known = known_.find(name); known != known_.end()) {
        if (!known->second) user.fail(fmt::format("`{}` is made of itself", name));
        return known->second;
    }
    const auto value = find("substances", name);
    if (!value) {
        const auto names = names_of("substances");
        throw UsageError(fmt::format("{}there is no substance `{}`{}",
                                     user.is_text() ? user.where() : user.where_key(), name,
                                     suggestion(name, {names.begin(), names.end()})));
    }
    known_[name] = nullptr;
    return known_[name] = read(*value);
}

RecipeReader::Named RecipeReader::read(const Value& value)
{
    const Section section(value);
    section.allow({"law", "spectrum", "mixture", "dissolved"});
    Substance substance{.where = value.where()};
    if (section.values().empty())
        value.fail("a substance needs a `law`, a `spectrum`, a `mixture` or what is `dissolved`");
    if (const auto of = section.find("law")) substance.law = law(*of);
    if (const auto of = section.find("spectrum")) read_spectrum_of(Section(*of), substance);
    if (const auto of = section.find("mixture")) substance.mixture = mixture(*of);
    if (const auto of = section.find("dissolved")) substance.dissolved = dissolved(*of);
    return std::make_shared<const Substance>(std::move(substance));
}

void RecipeReader::read_spectrum_of(const Section& spectrum, Substance& substance) const
{
    spectrum.allow({"file", "column", "unit", "decadic", "molar_mass"});
    const auto unit = spectrum.at("unit").choice({"1/cm", "1/mm", "1/(cm g/L)", "1/(cm M)"});
    const auto molar_mass = spectrum.find("molar_mass");
    substance.needs_concentration = unit >= 2;
    if (unit == 1) substance.unit = 10;
    if (unit == 3) substance.unit = 1 / spectrum.at("molar_mass").number(1e-3, 1e9);
    if (unit != 3 && molar_mass) molar_mass->fail("`molar_mass` is for the unit \"1/(cm M)\"");
    if (const auto decadic = spectrum.find("decadic"); decadic && decadic->flag())
        substance.unit *= std::numbers::ln10;
    const Value file = spectrum.at("file"), column = spectrum.at("column");
    substance.spectrum =
        std::make_shared<const Spectrum>(open_spectrum(file, folder_, column.text()));
}

std::vector<Part> RecipeReader::mixture(const Value& value)
{
    std::vector<Part> parts;
    for (const Value& share : Section(value).values()) {
        Part part{share.name(), named(share, share.name()), std::nullopt};
        if (part.of->needs_concentration)
            share.fail(fmt::format("`{}` needs a concentration; it can be `dissolved`", part.name));
        if (!(share.is_text() && share.text() == "rest")) part.amount = amount(share);
        const auto is_rest = [](const Part& other) { return !other.amount; };
        if (!part.amount && std::ranges::any_of(parts, is_rest))
            share.fail("there is a \"rest\" already");
        parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<Part> RecipeReader::dissolved(const Value& value)
{
    std::vector<Part> parts;
    for (const Value& share : Section(value).values()) {
        Part part{share.name(), named(share, share.name()), amount(share)};
        if (!part.of->needs_concentration)
            share.fail(fmt::format("`{}` has no absorption per g/L; it can be part of a `mixture`",
                                   part.name));
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace gonio::skin

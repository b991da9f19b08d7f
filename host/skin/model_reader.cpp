// SPDX-License-Identifier: Apache-2.0
// Reads models of skin: those that are built in, and files of users.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/errors.hpp"
#include "gonio/model.hpp"
#include "gonio/skin.hpp"
#include "scene/document.hpp"
#include "skin/recipe_reader.hpp"

namespace gonio {
namespace skin {
namespace {

constexpr double least_known = 100, greatest_known = 10000;  // nm, where no spectrum sets a limit
constexpr std::string_view folder = "skin/models/", ending = ".toml";

std::string text_or_empty(const Section& section, std::string_view key)
{
    const auto value = section.find(key);
    return value ? value->text() : "";
}

SkinParameter read_parameter(const Value& value)
{
    const Section section(value);
    section.allow({"doc", "unit", "least", "greatest", "default", "held"});
    SkinParameter parameter{.name = value.name(), .unit = "1"};
    if (const auto unit = section.find("unit")) {
        const std::vector<std::string_view> units = {"1", "cm", "g/L"};
        parameter.unit = units[unit->choice(units)];
    }
    parameter.doc = section.at("doc").text();
    parameter.least = section.at("least").number();
    parameter.greatest = section.at("greatest").number(parameter.least);
    parameter.preset = section.at("default").number(parameter.least, parameter.greatest);
    return parameter;
}

LayerRecipe read_layer(const Section& layer, RecipeReader& reader)
{
    layer.allow({"name", "d", "n", "absorption", "mus", "musp", "g", "phase"});
    LayerRecipe recipe;
    if (const auto d = layer.find("d")) recipe.thickness = reader.amount(*d);
    recipe.n = reader.law(layer.at("n"));
    recipe.absorption = reader.substance(layer.at("absorption"));
    const auto reduced = layer.find("musp"), full = layer.find("mus");
    if (reduced && full) reduced->fail("a layer has a `mus` or a `musp`, not both");
    recipe.reduced = reduced.has_value();
    recipe.scattering = reader.law(reduced ? *reduced : layer.at("mus"));
    const auto phase = layer.find("phase");
    const auto kind = phase ? phase->choice({"henyey_greenstein", "isotropic", "rayleigh"}) : 0;
    const auto g = layer.find("g");
    if (kind != 0 && g) g->fail("`g` is for the phase function henyey_greenstein");
    if (kind == 0) recipe.g = reader.law(layer.at("g"));
    if (kind == 1) recipe.phase = Isotropic{};
    if (kind == 2) recipe.phase = Rayleigh{};
    return recipe;
}

/// Above, below, and the bottom.
LayeredMedium read_surroundings(const Section& root)
{
    LayeredMedium medium;
    if (const auto n = root.find("n_above")) medium.n_above = n->number();
    if (const auto n = root.find("n_below")) medium.n_below = n->number();
    if (const auto bottom = root.find("bottom"))
        medium.bottom =
            std::vector{Bottom::open, Bottom::black, Bottom::mirror,
                        Bottom::diffuse}[bottom->choice({"open", "black", "mirror", "diffuse"})];
    if (const auto albedo = root.find("bottom_albedo")) medium.bottom_albedo = albedo->number(0, 1);
    return medium;
}

/// The wavelengths that the model itself allows, and those of its spectra.
void set_range(const Section& root, Recipe& recipe)
{
    recipe.least_wavelength = least_known;
    recipe.greatest_wavelength = greatest_known;
    if (const auto range = root.find("wavelengths")) {
        const std::vector<double> ends = range->numbers();
        if (ends.size() != 2 || !(ends[0] >= least_known && ends[0] <= ends[1]))
            range->fail(fmt::format("`wavelengths` are the first and the last, in nm, from {} on",
                                    least_known));
        recipe.least_wavelength = ends[0];
        recipe.greatest_wavelength = ends[1];
    }
    const auto narrow = [&](const Spectrum& spectrum) {
        const auto& at = spectrum.wavelengths();
        if (at.front() > recipe.least_wavelength) {
            recipe.least_wavelength = at.front();
            recipe.least_by = spectrum.name();
        }
        if (at.back() < recipe.greatest_wavelength) {
            recipe.greatest_wavelength = at.back();
            recipe.greatest_by = spectrum.name();
        }
    };
    for (const LayerRecipe& layer : recipe.layers) layer.absorption->for_spectra(narrow);
}

/// Refuses a parameter that changes nothing: a name that was mistyped elsewhere.
void check_use(const Section& root, const SkinModel& model, const RecipeReader& reader)
{
    for (std::size_t k = 0; k < model.parameters.size(); ++k)
        if (!reader.has_used(k))
            Section(root.at("parameters"))
                .at(model.parameters[k].name)
                .fail(fmt::format("nothing uses the parameter `{}`", model.parameters[k].name));
}

SkinModel read_model(std::string_view text, const std::string& file, std::string id,
                     const std::filesystem::path& beside)
{
    const toml::table document = parse_document(text, file);
    const Section root(Value(document, "the model", document.source().begin));
    root.allow({"title", "citation", "notes", "wavelengths", "n_above", "n_below", "bottom",
                "bottom_albedo", "parameters", "laws", "substances", "layers"});
    SkinModel model{.id = std::move(id),
                    .title = text_or_empty(root, "title"),
                    .citation = text_or_empty(root, "citation")};
    if (const auto notes = root.find("notes"))
        for (const Value& note : notes->list()) model.notes.push_back(note.text());
    if (const auto parameters = root.find("parameters"))
        for (const Value& value : Section(*parameters).values()) {
            model.parameters.push_back(read_parameter(value));
            const auto held = Section(value).find("held");
            if (held && held->flag()) model.held.push_back(value.name());
        }

    const toml::table library = parse_document(*find_data("skin/library.toml"), "library.toml");
    const Section shared(Value(library, "the library", library.source().begin));
    RecipeReader reader(model.parameters, {root, shared}, beside);
    Recipe recipe{.around = read_surroundings(root)};
    const Value layers = root.at("layers");
    for (const Value& value : layers.list()) {
        const Section layer(value);
        model.layers.push_back(layer.at("name").text());
        recipe.layers.push_back(read_layer(layer, reader));
    }
    check_use(root, model, reader);
    recipe.where = layers.where();
    set_range(root, recipe);
    model.recipe = std::make_shared<const Recipe>(std::move(recipe));
    const Skin skin(model);
    for (const double end : {skin.least_wavelength(), skin.greatest_wavelength()})
        static_cast<void>(skin.layers_at(end));  // the defaults must be allowed everywhere
    return model;
}

}  // namespace
}  // namespace skin

std::vector<std::string> skin_model_names()
{
    std::vector<std::string> names;
    for (const std::string_view path : skin::data_paths(skin::folder))
        names.emplace_back(path.substr(0, path.size() - skin::ending.size()));
    return names;
}

SkinModel find_skin_model(const std::string& name_or_file)
{
    if (name_or_file.ends_with(skin::ending)) {
        const std::filesystem::path path = name_or_file;
        return skin::read_model(read_document(path), name_or_file, path.stem().string(),
                                path.parent_path().empty() ? "." : path.parent_path());
    }
    const std::string file = std::string(skin::folder) + name_or_file + std::string(skin::ending);
    if (const std::string_view* text = skin::find_data(file))
        return skin::read_model(*text, file, name_or_file, {});
    const auto names = skin_model_names();
    throw UsageError(fmt::format("there is no skin `{}`{}", name_or_file,
                                 suggestion(name_or_file, {names.begin(), names.end()})));
}

}  // namespace gonio

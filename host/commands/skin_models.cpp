// SPDX-License-Identifier: Apache-2.0
// Prints models of skin: citation, layers, parameters with their ranges.
#include "commands/skin_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gonio/skin.hpp"

namespace gonio {
namespace {

bool is_held(const SkinModel& model, const std::string& parameter)
{
    return std::ranges::find(model.held, parameter) != model.held.end();
}

nlohmann::ordered_json json_of(const SkinModel& model)
{
    const Skin skin(model);
    nlohmann::ordered_json json{{"id", model.id},
                                {"title", model.title},
                                {"citation", model.citation},
                                {"notes", model.notes},
                                {"least_wavelength", skin.least_wavelength()},
                                {"greatest_wavelength", skin.greatest_wavelength()},
                                {"layers", model.layers},
                                {"parameters", nlohmann::ordered_json::array()}};
    for (const auto& [name, unit, least, greatest, preset, doc] : model.parameters)
        json["parameters"].push_back({{"name", name},
                                      {"unit", unit},
                                      {"least", least},
                                      {"greatest", greatest},
                                      {"default", preset},
                                      {"doc", doc},
                                      {"held", is_held(model, name)}});
    return json;
}

void print(const SkinModel& model)
{
    const Skin skin(model);
    fmt::print("{}: {}\n{}\n", model.id, model.title, model.citation);
    for (const std::string& note : model.notes) fmt::print("{}\n", note);
    fmt::print("\n{} to {} nm. Layers: {}\n", skin.least_wavelength(), skin.greatest_wavelength(),
               fmt::join(model.layers, ", "));
    if (!model.parameters.empty()) fmt::print("\nParameters\n");
    for (const auto& [name, unit, least, greatest, preset, doc] : model.parameters)
        fmt::print("  --{:<20} {}: {} to {}{}, default {}{}\n", name, doc, least, greatest,
                   unit == "1" ? "" : " " + unit, preset,
                   is_held(model, name) ? "; fits keep it" : "");
}

}  // namespace

void print_skin_models(const std::string& name, bool json)
{
    if (!name.empty()) {
        const SkinModel model = find_skin_model(name);
        if (json) return fmt::print("{}\n", json_of(model).dump(2));
        return print(model);
    }
    nlohmann::ordered_json all;
    for (const std::string& id : skin_model_names()) {
        const SkinModel model = find_skin_model(id);
        if (json)
            all["skin_models"].push_back(json_of(model));
        else
            fmt::print("{:<20} {}. {}\n", id, model.title, model.citation);
    }
    if (json) return fmt::print("{}\n", all.dump(2));
    fmt::print("\n`gonio models --skin ID` says more about one of them.\n");
}

}  // namespace gonio

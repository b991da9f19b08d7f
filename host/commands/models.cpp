// SPDX-License-Identifier: Apache-2.0
// gonio models [ID]: the catalogue, all about one model, and its plot.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/parameters.hpp"
#include "gonio/errors.hpp"
#include "gonio/material.hpp"
#include "output/model_plot.hpp"

namespace gonio {
namespace {

nlohmann::ordered_json json_of(const Parameter& parameter)
{
    nlohmann::ordered_json json{{"name", parameter.name}, {"doc", parameter.doc}};
    if (parameter.kind == Kind::choice) {
        json["default"] = parameter.options[static_cast<std::size_t>(parameter.preset)].name;
        for (const Option& option : parameter.options)
            json["options"].push_back({{"name", option.name}, {"doc", option.doc}});
        return json;
    }
    json["per_channel"] = parameter.kind == Kind::color;
    json["unit"] = parameter.unit;
    json["least"] = parameter.least;
    json["greatest"] = parameter.greatest;
    json["default"] = parameter.preset;
    return json;
}

nlohmann::ordered_json json_of(const Model& model)
{
    nlohmann::ordered_json json{{"id", model.id},
                                {"title", model.title},
                                {"citation", model.citation},
                                {"reciprocal", (model.traits & ONE_WAY) == 0},
                                {"measure", (model.traits & VALUE) != 0 ? "value" : "brdf"},
                                {"notes", nlohmann::ordered_json::array()},
                                {"parameters", nlohmann::ordered_json::array()}};
    for (const std::string_view note : model.notes) json["notes"].push_back(note);
    for (const Parameter& parameter : model.parameters)
        json["parameters"].push_back(json_of(parameter));
    for (const Both& both : model.both)
        json["parameters"].push_back({{"name", both.alias}, {"sets", {both.first, both.second}}});
    return json;
}

void print(const Parameter& parameter)
{
    if (parameter.kind == Kind::choice) {
        fmt::print("  --{:<12} {}\n", parameter.name, parameter.doc);
        for (const Option& option : parameter.options)
            fmt::print("      {:<20} {}{}{}{}\n", option.name, option.doc,
                       &option == &parameter.options[static_cast<std::size_t>(parameter.preset)]
                           ? " (default)"
                           : "",
                       (option.traits & VALUE) != 0 ? "; prints a value, not a BRDF" : "",
                       (option.traits & ONE_WAY) != 0 ? "; not reciprocal" : "");
        return;
    }
    fmt::print("  --{:<12} {}: {} to {}{}, default {}{}\n", parameter.name, parameter.doc,
               parameter.least, parameter.greatest,
               parameter.unit == "1" ? "" : fmt::format(" {}", parameter.unit), parameter.preset,
               parameter.kind == Kind::color ? "; one number or one per channel" : "");
}

/// " (ndf = ggx)", or nothing where the alias only names its model.
std::string setting_of(const Alias& alias)
{
    return alias.choice.empty() ? "" : fmt::format(" ({} = {})", alias.choice, alias.option);
}

void print(const Model& model)
{
    fmt::print("{}: {}\n{}\n", model.id, model.title, model.citation);
    fmt::print("{}; {}.\n", (model.traits & ONE_WAY) != 0 ? "Not reciprocal" : "Reciprocal",
               (model.traits & VALUE) != 0 ? "prints a value that contains cos theta_i: quantity "
                                             "brdf is that value divided by cos theta_i"
                                           : "a BRDF in 1/sr");
    for (const std::string_view note : model.notes) fmt::print("{}\n", note);
    for (const Alias& alias : aliases())
        if (alias.model == model.id)
            fmt::print("Also known as {}{}.\n", alias.name, setting_of(alias));
    fmt::print("\nParameters\n");
    for (const Parameter& parameter : model.parameters) print(parameter);
    for (const Both& both : model.both)
        fmt::print("  --{:<12} sets {} and {}\n", both.alias, both.first, both.second);
}

void list(bool json)
{
    if (json) {
        nlohmann::ordered_json array;
        for (const Model& model : models()) array.push_back(json_of(model));
        fmt::print("{}\n", nlohmann::ordered_json{{"models", array}}.dump(2));
        return;
    }
    for (const Model& model : models())
        fmt::print("{:<21} {}. {}\n", model.id, model.title, model.citation);
    for (const Alias& alias : aliases())
        fmt::print("{:<21} {}{}\n", alias.name, alias.model, setting_of(alias));
    fmt::print("\n`gonio models ID` says more about one of them.\n");
}

}  // namespace

void add_models(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand("models", "List the reflectance models, or all about one");
    const auto id = std::make_shared<std::string>();
    const auto json = std::make_shared<bool>(false);
    const auto plot = std::make_shared<std::string>();
    verb->add_option("ID", *id,
                     "a model or an alias; for a plot its parameters follow as --name value");
    verb->add_option("--plot", *plot,
                     "draw its lobe at four angles and its directional albedo: .png or .svg");
    verb->add_flag("--json", *json, "Print JSON");
    verb->allow_extras();
    verb->callback([verb, id, json, plot] {
        const std::vector<std::string> words = verb->remaining();
        if (plot->empty() && !words.empty())
            throw UsageError(fmt::format("what is `{}`? Parameters are for --plot", words.front()));
        if (id->empty() && !plot->empty()) throw UsageError("--plot needs the ID of a model");
        if (id->empty()) return list(*json);
        if (!plot->empty())
            return write_model_plot(*plot, Material{*id, {lobe_of_words(*id, words)}});
        const Model& model = *default_lobe(*id).model;
        if (*json)
            fmt::print("{}\n", json_of(model).dump(2));
        else
            print(model);
    });
}

}  // namespace gonio

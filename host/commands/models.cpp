// SPDX-License-Identifier: Apache-2.0
// gonio models [ID]: the catalogue, all about one model, and its plot.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/measured_models.hpp"
#include "commands/parameters.hpp"
#include "commands/skin_models.hpp"
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
    if (parameter.kind == Kind::table) {
        json["file"] = true;
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
                                {"sampled", (model.traits & SAMPLED) != 0},
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
    if (parameter.kind == Kind::table) {
        fmt::print("  --{:<12} {}\n", parameter.name, parameter.doc);
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
    if ((model.traits & SAMPLED) != 0) fmt::print("`gonio sample` draws viewers for it.\n");
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
    fmt::print(
        "\n`gonio models ID` says more about one of them, and --measure how accurate and fast "
        "it is on your device.\n");
}

}  // namespace

void add_models(CLI::App& app)
{
    struct Options {
        std::string id, plot;
        bool measure = false, json = false, skin = false;
        DeviceOptions device;
    };
    CLI::App* verb = app.add_subcommand("models", "List the reflectance models, or all about one");
    const auto options = std::make_shared<Options>();
    verb->add_option("ID", options->id,
                     "a model or an alias; for a plot its parameters follow as --name value");
    verb->add_option("--plot", options->plot,
                     "draw its lobe at four angles and its directional albedo: .png or .svg");
    CLI::Option* measure = verb->add_flag(
        "--measure", options->measure,
        "measure accuracy, speed and the largest directional albedo, of one model or of all");
    CLI::Option* skin =
        verb->add_flag("--skin", options->skin, "list the models of skin, or all about one of them")
            ->excludes(measure);
    verb->add_flag("--json", options->json, "Print JSON");
    options->device.add_to(*verb);
    verb->allow_extras();
    verb->get_option("--plot")->excludes(measure)->excludes(skin);
    verb->callback([verb, options] {
        const std::string& id = options->id;
        const std::vector<std::string> words = verb->remaining();
        if (options->plot.empty() && !words.empty())
            throw UsageError(fmt::format("what is `{}`? Parameters are for --plot", words.front()));
        if (options->skin) return print_skin_models(id, options->json);
        if (id.empty() && !options->plot.empty())
            throw UsageError("--plot needs the ID of a model");
        if (!options->plot.empty())
            return write_model_plot(options->plot, Material{id, {lobe_of_words(id, words)}});
        const Model* model = id.empty() ? nullptr : default_lobe(id).model;
        if (options->measure) {
            std::vector<const Model*> chosen{model};
            if (!model) {
                chosen.clear();
                for (const Model& each : models()) chosen.push_back(&each);
            }
            return print_measured(options->device.open(), chosen, options->json);
        }
        if (!model) return list(options->json);
        if (options->json)
            fmt::print("{}\n", json_of(*model).dump(2));
        else
            print(*model);
    });
}

}  // namespace gonio

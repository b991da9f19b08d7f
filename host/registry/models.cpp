// SPDX-License-Identifier: Apache-2.0
// The registry as data, made from models.inc.
#include "gonio/model.hpp"

#include <algorithm>

namespace gonio {
namespace {

// The macros walk through a block in its order, so that each line adds to what the line before has
// opened.
struct Builder {
    std::vector<Model> models;
    std::vector<Alias> aliases;

    Builder()
    {
#define MODEL(id, title, citation, traits) \
    models.push_back({#id, title, citation, traits, {}, {}, {}, {}, {}});
#define NOTE(id, text) models.back().notes.push_back(text);
#define SCALAR(id, name, unit, least, greatest, preset, doc) \
    models.back().parameters.push_back(                      \
        {Kind::scalar, #name, unit, least, greatest, preset, doc, {}});
#define COLOR(id, name, unit, least, greatest, preset, doc) \
    models.back().parameters.push_back(                     \
        {Kind::color, #name, unit, least, greatest, preset, doc, {}});
#define TABLE(id, name, doc) \
    models.back().parameters.push_back({Kind::table, #name, "1", 0, 0, 0, doc, {}});
#define CHOICE(id, name, preset, doc)                 \
    {                                                 \
        const std::string_view preset_name = #preset; \
        models.back().parameters.push_back({Kind::choice, #name, "", 0, 0, 0, doc, {}});
#define OPTION(id, name, option, traits, doc) \
    models.back().parameters.back().options.push_back({#option, traits, doc});
#define END_CHOICE(id, name)    \
    finish_choice(preset_name); \
    }
#define BOTH(id, alias, first, second) models.back().both.push_back({#alias, #first, #second});
#define ISOTROPIC_AT(id, name, number) models.back().isotropic_at.push_back({#name, number});
#define DARK_AT(id, name, number) models.back().dark_at.push_back({#name, number});
#define ALIAS(alias, id, choice, option) aliases.push_back({#alias, #id, #choice, #option});
#include "gonio/shared/models.inc"
    }

    void finish_choice(std::string_view preset)
    {
        Parameter& choice = models.back().parameters.back();
        const auto found = std::ranges::find(choice.options, preset, &Option::name);
        choice.preset = static_cast<double>(found - choice.options.begin());
        choice.greatest = static_cast<double>(choice.options.size()) - 1;
    }
};

const Builder& registry()
{
    static const Builder built;
    return built;
}

}  // namespace

std::size_t Model::index_of(std::string_view name) const
{
    const auto found = std::ranges::find(parameters, name, &Parameter::name);
    return found == parameters.end() ? npos : static_cast<std::size_t>(found - parameters.begin());
}

const std::vector<Model>& models()
{
    return registry().models;
}
const std::vector<Alias>& aliases()
{
    return registry().aliases;
}

const Model* find_model(std::string_view id)
{
    const auto found = std::ranges::find(models(), id, &Model::id);
    return found == models().end() ? nullptr : &*found;
}

}  // namespace gonio

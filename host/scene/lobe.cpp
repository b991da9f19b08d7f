// SPDX-License-Identifier: Apache-2.0
// Reads a model with its parameters. Lobe::set knows what is allowed; here it learns its place.
#include "scene/lobe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "gonio/model.hpp"
#include "scene/sweep.hpp"

namespace gonio {
namespace {

bool is_table(const Model& model, std::string_view name)
{
    const std::size_t index = model.index_of(name);
    return index != Model::npos && model.parameters[index].kind == Kind::table;
}

std::vector<std::string_view> names_of(const Model& model)
{
    std::vector<std::string_view> names;
    for (const Parameter& parameter : model.parameters) names.push_back(parameter.name);
    return names;
}

/// Sets parameters of one lobe, each once.
class LobeReader {
public:
    LobeReader(const Value& model, std::size_t part, std::vector<Sweep>& sweeps)
        : part_(part), sweeps_(sweeps)
    {
        const auto name = model.text();
        lobe_ = located(model.where(), [&] { return default_lobe(name); });
        const auto alias = std::ranges::find(aliases(), name, &Alias::name);
        if (alias != aliases().end() && !alias->choice.empty())
            set_by_.emplace(alias->choice, alias->name);
    }

    void read(const Value& value)
    {
        claim(value);
        if (value.is_table())
            sweep(value);
        else if (value.is_text())
            located(value.where(), [&] { lobe_.set(value.name(), value.text()); });
        else
            set(value, value.is_list() ? value.numbers() : std::vector{value.number()});
    }

    Lobe lobe() const { return lobe_; }

private:
    void set(const Value& value, const std::vector<double>& numbers)
    {
        located(value.where(), [&] { lobe_.set(value.name(), numbers); });
    }

    /// The last value that is set is the first of the sweep.
    void sweep(const Value& value)
    {
        sweeps_.push_back(read_sweep(value, part_));
        const auto& values = sweeps_.back().values;
        for (auto number = values.rbegin(); number != values.rend(); ++number)
            set(value, {*number});
    }

    /// Refuses a name that the model does not have, and one that something else has set.
    void claim(const Value& value)
    {
        std::vector<std::string_view> names{value.name()};
        const auto& model = *lobe_.model;
        const auto both = std::ranges::find(model.both, value.name(), &Both::alias);
        if (both != model.both.end())
            names = {both->first, both->second};
        else if (is_table(model, value.name()))
            names = names_of(model);  // its file gives the other parameters too
        else if (value.name() != "weight" && model.index_of(value.name()) == Model::npos)
            located(value.where_key(), [&] { lobe_.set(value.name(), std::vector{0.0}); });
        for (const auto name : names) {
            const auto [earlier, is_new] = set_by_.emplace(name, value.name());
            if (!is_new)
                throw UsageError(fmt::format("{}`{}` and `{}` both set `{}`", value.where_key(),
                                             earlier->second, value.name(), name));
        }
    }

    Lobe lobe_;
    std::size_t part_;
    std::vector<Sweep>& sweeps_;
    std::map<std::string, std::string, std::less<>> set_by_;
};

}  // namespace

Lobe read_lobe(const Section& section, std::size_t part, std::vector<Sweep>& sweeps)
{
    LobeReader reader(section.at("model"), part, sweeps);
    if (const auto weight = section.find("weight")) reader.read(*weight);
    if (const auto parameters = section.find("parameters"))
        for (const Value& value : Section(*parameters).values()) reader.read(value);
    return reader.lobe();
}

}  // namespace gonio

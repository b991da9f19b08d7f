// SPDX-License-Identifier: Apache-2.0
// What parameters are called among all lobes of a material.
#include "plan/lobe_names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonio {

std::vector<std::string> parameters_of(const Model& model, const std::string& name)
{
    const auto both = std::ranges::find(model.both, name, &Both::alias);
    if (both == model.both.end()) return {name};
    return {std::string(both->first), std::string(both->second)};
}

std::vector<std::string> lobe_prefixes(const std::vector<Lobe>& lobes)
{
    if (lobes.size() == 1) return {""};
    std::vector<std::string> prefixes;
    for (std::size_t k = 0; k < lobes.size(); ++k) {
        const auto same = [&](const Lobe& lobe) { return lobe.model == lobes[k].model; };
        const auto earlier = std::ranges::count_if(
            lobes.begin(), lobes.begin() + static_cast<std::ptrdiff_t>(k), same);
        const bool single = std::ranges::count_if(lobes, same) == 1;
        prefixes.push_back(single ? fmt::format("{}.", lobes[k].model->id)
                                  : fmt::format("{}_{}.", lobes[k].model->id, earlier + 1));
    }
    return prefixes;
}

Axis sweep_axis(const Sweep& sweep, const std::vector<Lobe>& lobes)
{
    const Model& model = *lobes[sweep.part].model;
    const auto index = model.index_of(parameters_of(model, sweep.parameter).front());
    const auto unit = index == Model::npos ? "1" : std::string(model.parameters[index].unit);
    return {lobe_prefixes(lobes)[sweep.part] + sweep.parameter, unit, sweep.values, Samples::node};
}

}  // namespace gonio

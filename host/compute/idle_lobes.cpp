// SPDX-License-Identifier: Apache-2.0
// Lobes that add nothing, and facets that reflect the same in every direction.
#include "compute/idle_lobes.hpp"

#include <algorithm>

#include "compute/distinct_channels.hpp"

namespace gonio {

std::optional<double> even_facet_reflectance(const Lobe& lobe)
{
    const std::size_t fresnel = lobe.model->index_of("fresnel");
    if (fresnel == Model::npos) return {};
    const auto is = [&](const char* name, double number) {
        return all_are(lobe.values[lobe.model->index_of(name)], number);
    };
    const auto chosen = static_cast<std::size_t>(lobe.values[fresnel].front());
    const std::string_view option = lobe.model->parameters[fresnel].options[chosen].name;
    if (option == "schlick") return is("f0", 1) ? std::optional(1.0) : std::nullopt;
    const bool clear = option == "dielectric" || is("k", 0);
    return clear && is("eta", 1) ? std::optional(0.0) : std::nullopt;
}

bool is_idle(const Lobe& lobe)
{
    const bool dark = std::ranges::any_of(lobe.model->dark_at, [&](const ParameterAt& at) {
        return all_are(lobe.values[lobe.model->index_of(at.name)], at.number);
    });
    return dark || all_are(lobe.weight, 0) || even_facet_reflectance(lobe) == 0;
}

Material without_idle_lobes(const Material& material)
{
    Material rest = material;
    std::erase_if(rest.lobes, is_idle);
    if (rest.lobes.empty()) {
        // A program has one lobe at least: the one that costs least.
        rest.lobes = {default_lobe("lambert")};
        rest.lobes.front().weight = {0};
    }
    // The lobes that are gone may have been the only ones with numbers for each channel.
    std::vector<double>& weight = rest.lobes.front().weight;
    if (rest.channels() < material.channels()) weight.assign(material.channels(), weight.front());
    return rest;
}

std::vector<std::size_t> lobes_with_light(const std::vector<Material>& materials)
{
    std::vector<std::size_t> lit;
    for (std::size_t k = 0; k < materials.front().lobes.size(); ++k)
        if (!std::ranges::all_of(materials, [&](const Material& m) { return is_idle(m.lobes[k]); }))
            lit.push_back(k);
    return lit;
}

}  // namespace gonio

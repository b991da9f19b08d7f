// SPDX-License-Identifier: Apache-2.0
// Layers with values of sweeps.
#include "plan/swept_layers.hpp"

#include <fmt/format.h>

#include "gonio/errors.hpp"
#include "scene/located.hpp"

namespace gonio {
namespace {

/// Where a layer keeps what a scene calls so.
double& number_of(Layer& layer, const std::string& name)
{
    if (name == "mua") return layer.mua;
    if (name == "mus") return layer.mus;
    if (name == "n") return layer.n;
    if (name == "d") return layer.d;
    if (name == "g") return std::get<HenyeyGreenstein>(layer.phase).g;
    auto& phase = std::get<TwoTermHenyeyGreenstein>(layer.phase);
    return name == "g_1" ? phase.g_1 : name == "g_2" ? phase.g_2 : phase.weight_1;
}

}  // namespace

LayeredMedium swept_layers(LayeredMedium medium, const std::vector<Sweep>& sweeps,
                           const std::vector<double>& point)
{
    for (std::size_t k = 0; k < sweeps.size(); ++k) {
        const Sweep& sweep = sweeps[k];
        if (sweep.axis)
            throw UsageError(
                fmt::format("{}of layers every value of a sweep makes a file; write as = \"files\"",
                            sweep.where));
        number_of(medium.layers[sweep.part], sweep.parameter) = point[k];
        located(sweep.where, [&] { validate(medium); });
    }
    return medium;
}

std::string name_of_layers(const LayeredMedium& medium, const std::vector<Sweep>& sweeps,
                           const std::vector<double>& point)
{
    std::string name;
    for (std::size_t k = 0; k < sweeps.size(); ++k) {
        const std::string layer =
            medium.layers.size() > 1 ? fmt::format("layer_{}.", sweeps[k].part + 1) : "";
        name += fmt::format("-{}{}={}", layer, sweeps[k].parameter, point[k]);
    }
    return name;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Reflectances of bands by angle, added up by their colours.
#include "picture/layer_reflectance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "parallel.hpp"
#include "reference/adding_doubling.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr std::size_t nodes = LayerReflectance::angles;
constexpr double least_root = 0.05;  // of a node's cosine
constexpr double tolerance = 1e-3;

double cosine_of(std::size_t node)
{
    const double root = std::max(least_root, static_cast<double>(node) / (nodes - 1));
    return root * root;
}

/// At each node, what returns of the light that has passed the smooth surface.
std::vector<double> returned(const LayeredMedium& layers)
{
    reference::LightRequest request;
    for (std::size_t node = 0; node < nodes; ++node)
        request.incidence.push_back(std::acos(cosine_of(node)));
    std::vector<double> parts;
    for (const auto& under : reference::solve_layers_to(layers, request, tolerance).collimated)
        parts.push_back(under.budget.diffuse_reflectance / (1 - under.budget.specular));
    return parts;
}

}  // namespace

LayerReflectance::LayerReflectance(const Device& device, const std::vector<ColourBand>& bands,
                                   const Material& surface, const std::function<void()>& after_each)
    : surface_(device, surface), nodes_(nodes)
{
    std::vector<std::vector<double>> parts(bands.size());
    in_parallel(bands.size(), [&](std::size_t k) {
        parts[k] = returned(bands[k].layers);
        after_each();
    });
    for (std::size_t node = 0; node < nodes; ++node) {
        for (std::size_t k = 0; k < bands.size(); ++k)
            nodes_[node] += bands[k].colour * parts[k][node];
        nodes_[node] = glm::max(dvec3(0), nodes_[node]);
    }

    // The mean is that of what at() gives: 2 mu over d mu, mu = t^2, by the midpoint rule.
    constexpr int steps = 4096;
    for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        mean_ += 4 * t * t * t / steps * at(t * t);
    }
}

dvec3 LayerReflectance::at(double cosine) const
{
    const double place = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * (nodes - 1);
    const auto node = std::min(static_cast<std::size_t>(place), nodes - 2);
    return glm::max(dvec3(0), 1.0 - surface_.at(cosine, 0)) *
           glm::mix(nodes_[node], nodes_[node + 1], place - static_cast<double>(node));
}

}  // namespace gonio

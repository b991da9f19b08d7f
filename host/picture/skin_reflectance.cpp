// SPDX-License-Identifier: Apache-2.0
// Spectra of skin by angle, seen by the CIE 1931 observer.
#include "picture/skin_reflectance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "gonio/albedo.hpp"
#include "gonio/colour.hpp"
#include "output/tone.hpp"
#include "parallel.hpp"
#include "reference/adding_doubling.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr std::size_t nodes = 25;
constexpr double least_root = 0.05;  // of a node's cosine
constexpr double tolerance = 1e-3, surface_error = 1e-4;

double cosine_of(std::size_t node)
{
    const double root = std::max(least_root, static_cast<double>(node) / (nodes - 1));
    return root * root;
}

/// [node][wavelength]: what returns of the light that has passed the smooth surface.
std::vector<std::vector<double>> returned(const Skin& skin, const std::vector<double>& wavelengths)
{
    reference::LightRequest request;
    for (std::size_t node = 0; node < nodes; ++node)
        request.incidence.push_back(std::acos(cosine_of(node)));
    std::vector<std::vector<double>> parts(nodes, std::vector<double>(wavelengths.size()));
    in_parallel(wavelengths.size(), [&](std::size_t k) {
        const auto solution =
            reference::solve_layers_to(skin.layers_at(wavelengths[k]), request, tolerance);
        for (std::size_t node = 0; node < nodes; ++node) {
            const reference::LightBudget& budget = solution.collimated[node].budget;
            parts[node][k] = budget.diffuse_reflectance / (1 - budget.specular);
        }
    });
    return parts;
}

}  // namespace

Lobe skin_surface(const Skin& skin)
{
    Lobe lobe = default_lobe("ggx");
    lobe.set("fresnel", "dielectric");
    lobe.set("eta", {skin.layers_at(580).layers.front().n});
    lobe.set("alpha", {0.35});
    return lobe;
}

SkinReflectance::SkinReflectance(const Device& device, const Skin& skin, const Material& surface)
{
    std::vector<double> wavelengths;
    for (int wavelength = 380; wavelength <= 780; wavelength += 20)
        wavelengths.push_back(wavelength);
    std::vector<AlbedoCell> cells;
    for (std::size_t node = 0; node < nodes; ++node) cells.push_back({0, {cosine_of(node), 0}});
    const Albedos reflected =
        integrate_albedos(device, {surface}, cells, {Fixed::light, surface_error});
    std::vector<std::vector<float>> planes;
    for (const auto& channel : reflected.value) planes.emplace_back(channel.begin(), channel.end());
    const std::vector<glm::vec3> albedos = as_rgb(planes);
    const auto parts = returned(skin, wavelengths);
    for (std::size_t node = 0; node < nodes; ++node)
        nodes_.push_back(glm::max(dvec3(0), 1.0 - dvec3(albedos[node])) *
                         glm::max(dvec3(0), linear_srgb(tristimulus(wavelengths, parts[node]))));

    // The mean is that of what at() gives: 2 mu over d mu, mu = t^2, by the midpoint rule.
    constexpr int steps = 4096;
    for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        mean_ += 4 * t * t * t / steps * at(t * t);
    }
}

dvec3 SkinReflectance::at(double cosine) const
{
    const double place = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * (nodes - 1);
    const auto node = std::min(static_cast<std::size_t>(place), nodes - 2);
    return glm::mix(nodes_[node], nodes_[node + 1], place - static_cast<double>(node));
}

}  // namespace gonio

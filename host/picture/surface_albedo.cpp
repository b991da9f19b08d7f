// SPDX-License-Identifier: Apache-2.0
// Integrates at the nodes, and blends between them.
#include "picture/surface_albedo.hpp"

#include <algorithm>
#include <cmath>

#include "gonio/albedo.hpp"
#include "output/tone.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr std::size_t cosines = SurfaceAlbedo::cosines, brushed_azimuths = 24;
constexpr double max_error = 1e-5;

/// At even steps of the square root, which is steep where the cosine is small; none is 0.
double cosine_of(std::size_t node)
{
    const double root = std::max(0.01, static_cast<double>(node) / (cosines - 1));
    return root * root;
}

/// The node below, and how far it is to the next one.
std::pair<std::size_t, double> between(double place, std::size_t nodes)
{
    const auto low = std::min(static_cast<std::size_t>(place), nodes - 1);
    return {low, place - static_cast<double>(low)};
}

}  // namespace

SurfaceAlbedo::SurfaceAlbedo(const Device& device, const Material& surface)
{
    if (surface.lobes.empty()) return;
    if (!surface.isotropic()) azimuths_ = brushed_azimuths;
    std::vector<AlbedoCell> cells;
    for (std::size_t a = 0; a < azimuths_; ++a)
        for (std::size_t k = 0; k < cosines; ++k)
            cells.push_back(
                {0,
                 {cosine_of(k), 360.0 * static_cast<double>(a) / static_cast<double>(azimuths_)}});
    const Albedos albedos = integrate_albedos(device, {surface}, cells, {Fixed::viewer, max_error});
    std::vector<std::vector<float>> planes;
    for (const auto& channel : albedos.value) planes.emplace_back(channel.begin(), channel.end());
    for (const glm::vec3 value : as_rgb(planes)) values_.emplace_back(value);
}

dvec3 SurfaceAlbedo::at(double cosine, double phi) const
{
    dvec3 sum(0);
    if (values_.empty()) return sum;
    const auto [node, up] =
        between(std::sqrt(std::clamp(cosine, 0.0, 1.0)) * (cosines - 1), cosines - 1);
    const double turns = (phi / 360 - std::floor(phi / 360)) * static_cast<double>(azimuths_);
    const auto [azimuth, on] = between(turns, azimuths_);
    for (const bool next : {false, true}) {
        const dvec3* row = values_.data() + (azimuth + next) % azimuths_ * cosines + node;
        sum += (next ? on : 1 - on) * ((1 - up) * row[0] + up * row[1]);
    }
    return sum;
}

}  // namespace gonio

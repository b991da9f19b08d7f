// SPDX-License-Identifier: Apache-2.0
// Lists the pairs of directions that samples and lights make, and has the device evaluate them.
#include "picture/surface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "gonio/albedo.hpp"
#include "gonio/compute.hpp"
#include "grid/local_pair.hpp"
#include "output/tone.hpp"
#include "parallel.hpp"
#include "picture/lights.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr std::size_t cosines = 64;  // of the uniform light's table: its error is below 1e-3
constexpr double uniform_error = 1e-5;

/// At even steps of the square root, which is steep where the cosine is small; none is 0.
double cosine_of(std::size_t node)
{
    const double root = std::max(0.01, static_cast<double>(node) / (cosines - 1));
    return root * root;
}

}  // namespace

Surface::Surface(const Device& device, const PictureRequest& picture, Material material)
    : device_(device), picture_(picture), material_(std::move(material))
{
    for (const PictureLight& light : picture.lights)
        if (const auto* uniform = std::get_if<UniformLight>(&light))
            uniform_light_ += uniform->radiance;
    if (uniform_light_ == dvec3(0)) return;
    if (!material_.isotropic()) azimuths_ = 24;
    std::vector<AlbedoCell> cells;
    for (std::size_t a = 0; a < azimuths_; ++a)
        for (std::size_t k = 0; k < cosines; ++k)
            cells.push_back(
                {0,
                 {cosine_of(k), 360.0 * static_cast<double>(a) / static_cast<double>(azimuths_)}});
    const Albedos albedos =
        integrate_albedos(device, {material_}, cells, {Fixed::viewer, uniform_error});
    std::vector<std::vector<float>> values;
    for (const auto& channel : albedos.value) values.emplace_back(channel.begin(), channel.end());
    for (const glm::vec3 value : as_rgb(values)) uniform_.emplace_back(value);
}

dvec3 Surface::uniform_reflectance(const Sample& sample) const
{
    const auto& [pixel, hit, viewer] = sample;
    const auto blend = [](double at, std::size_t count) {
        const auto low = std::min(static_cast<std::size_t>(at), count - 1);
        return std::pair(low, at - static_cast<double>(low));
    };
    const double cosine = std::clamp(glm::dot(viewer, hit.normal), 0.0, 1.0);
    const auto [node, up] = blend(std::sqrt(cosine) * (cosines - 1), cosines - 1);
    const double phi = local_pair(viewer, viewer, hit.normal, picture_.camera.up).phi_o + 360;
    const double turns = phi / 360 * static_cast<double>(azimuths_);
    const double whole = std::floor(turns);
    dvec3 sum(0);
    for (const bool next : {false, true}) {
        const std::size_t azimuth = (static_cast<std::size_t>(whole) + next) % azimuths_;
        const dvec3* row = uniform_.data() + azimuth * cosines + node;
        sum += (next ? turns - whole : 1 - (turns - whole)) * ((1 - up) * row[0] + up * row[1]);
    }
    return sum;
}

std::vector<dvec3> Surface::radiance(const Geometry& geometry, std::span<const Sample> samples)
{
    std::vector<dvec3> radiance(samples.size(), dvec3(rgb_of(material_.ambient)));
    if (!uniform_.empty())
        in_parallel(samples.size(), [&](std::size_t k) {
            radiance[k] += uniform_light_ * uniform_reflectance(samples[k]);
        });

    struct Share {
        std::size_t sample;
        dvec3 irradiance;
    };
    std::vector<DirectionPair> pairs;
    std::vector<Share> shares;
    for (const PictureLight& light : picture_.lights) {
        std::vector<std::optional<Arrival>> arrivals(samples.size());
        std::vector<DirectionPair> angles(samples.size());
        in_parallel(samples.size(), [&](std::size_t k) {
            const auto& [pixel, hit, viewer] = samples[k];
            arrivals[k] = arrival(light, hit, geometry);
            if (arrivals[k])
                angles[k] =
                    local_pair(arrivals[k]->towards, viewer, hit.normal, picture_.camera.up);
        });
        for (std::size_t k = 0; k < samples.size(); ++k) {
            if (!arrivals[k]) continue;
            pairs.push_back(angles[k]);
            shares.push_back({k, arrivals[k]->irradiance});
        }
    }
    const auto reflected = as_rgb(compute_points(device_, material_, Measure::brdf_cosine, pairs));
    for (std::size_t k = 0; k < shares.size(); ++k)
        radiance[shares[k].sample] += shares[k].irradiance * dvec3(reflected[k]);
    return radiance;
}

}  // namespace gonio

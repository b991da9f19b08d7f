// SPDX-License-Identifier: Apache-2.0
// Lists the pairs of directions that samples and lights make, and has the device evaluate them.
#include "picture/surface.hpp"

#include <glm/geometric.hpp>
#include <optional>

#include "gonio/compute.hpp"
#include "grid/local_pair.hpp"
#include "output/tone.hpp"
#include "parallel.hpp"
#include "picture/lights.hpp"

namespace gonio {
namespace {

using glm::dvec3;

}  // namespace

Surface::Surface(const Device& device, const PictureRequest& picture, Material material)
    : device_(device),
      picture_(picture),
      material_(std::move(material)),
      uniform_light_(uniform_radiance(picture.lights))
{
    if (uniform_light_ != dvec3(0)) albedo_.emplace(device, material_);
}

std::vector<dvec3> Surface::radiance(const Geometry& geometry,
                                     std::span<const Sample> samples) const
{
    std::vector<dvec3> radiance(samples.size(), dvec3(rgb_of(material_.ambient)));
    if (albedo_)
        in_parallel(samples.size(), [&](std::size_t k) {
            const auto& [pixel, hit, viewer] = samples[k];
            const double phi = local_pair(viewer, viewer, hit.normal, picture_.camera.up).phi_o;
            radiance[k] += uniform_light_ * albedo_->at(glm::dot(viewer, hit.normal), phi);
        });
    if (!material_.lobes.empty()) add_reflected(geometry, samples, radiance);
    return radiance;
}

void Surface::add_reflected(const Geometry& geometry, std::span<const Sample> samples,
                            std::vector<dvec3>& radiance) const
{
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
}

}  // namespace gonio

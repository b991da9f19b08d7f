// SPDX-License-Identifier: Apache-2.0
// Irradiance times what the layers return of it, averaged over the samples of each pixel.
#include "picture/skin_layers.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "parallel.hpp"
#include "picture/lights.hpp"

namespace gonio {
namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double least_cosine = 0.05;  // of a pixel's surface to the viewer, for its area

}  // namespace

SkinLayers::SkinLayers(const Device& device, const PictureRequest& picture, const Skin& skin,
                       const Material& surface)
    : device_(device),
      picture_(picture),
      reflectance_(device, skin, surface),
      profile_(fit_gaussians(trace_profile(device, skin, {.photons = picture.photons})).function),
      sums_{picture.width, picture.height, {}, {}, {}}
{
    const std::size_t pixels = picture.width * picture.height;
    sums_.place.resize(pixels);
    sums_.light.resize(pixels);
    sums_.area.resize(pixels);
    leaves_.resize(pixels);
}

void SkinLayers::enter(const Geometry& geometry, std::span<const Sample> samples)
{
    std::vector<dvec3> light(samples.size());
    in_parallel(samples.size(), [&](std::size_t k) {
        const Hit& hit = samples[k].hit;
        for (const PictureLight& each : picture_.lights) {
            if (const auto* uniform = std::get_if<UniformLight>(&each))
                light[k] += pi * uniform->radiance * reflectance_.mean();
            if (const auto found = arrival(each, hit, geometry)) {
                const double cosine = glm::dot(found->towards, hit.normal);
                light[k] += cosine * found->irradiance * reflectance_.at(cosine);
            }
        }
    });
    const double mm = 1000 * picture_.metres_per_unit;
    const double each = 1 / static_cast<double>(picture_.samples * picture_.samples);
    const double pixel = 2 * std::tan(glm::radians(picture_.camera.field_of_view) / 2) /
                         static_cast<double>(picture_.height);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const auto& [at, hit, viewer] = samples[k];
        const double cosine = std::max(least_cosine, glm::dot(hit.normal, viewer));
        const double side = mm * pixel * glm::distance(hit.position, picture_.camera.from);
        const double area = each * side * side / cosine;
        sums_.place[at] += area * mm * (hit.position - picture_.camera.to);
        sums_.light[at] += area * light[k];
        sums_.area[at] += area;
        leaves_[at] += each * reflectance_.at(cosine) / (pi * reflectance_.mean());
    }
}

void SkinLayers::leave(std::vector<dvec3>& image) const
{
    EnteringLight entering = sums_;
    for (std::size_t k = 0; k < image.size(); ++k) {
        if (entering.area[k] == 0) continue;
        entering.place[k] /= entering.area[k];
        entering.light[k] /= entering.area[k];
    }
    const std::vector<dvec3> light = spread_light(device_, entering, profile_);
    for (std::size_t k = 0; k < image.size(); ++k) image[k] += leaves_[k] * light[k];
}

}  // namespace gonio

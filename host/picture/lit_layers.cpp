// SPDX-License-Identifier: Apache-2.0
// Irradiance times what the layers return of it, averaged over the samples of each pixel.
#include "picture/lit_layers.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/common.hpp>
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

LayerReflectance solve(const Device& device, const PictureMaterial& material, PictureWork& work)
{
    work.begin("layers by angle");
    return {device, material.bands, material.surface, [&] { work.advance(work_of_band); }};
}

SumOfGaussians trace(const Device& device, const PictureMaterial& material, std::uint64_t photons,
                     PictureWork& work)
{
    work.begin("photons");
    const double all = work_of_photon * static_cast<double>(photons * material.bands.size());
    double told = 0;
    const auto profile =
        trace_profile(device, material.bands, {.photons = photons}, [&](double part) {
            work.advance((part - told) * all);
            told = part;
        });
    return fit_gaussians(profile).function;
}

}  // namespace

LitLayers::LitLayers(const Device& device, const PictureRequest& picture,
                     const PictureMaterial& material, PictureWork& work)
    : device_(device),
      picture_(picture),
      reflectance_(solve(device, material, work)),
      profile_(trace(device, material, picture.photons, work)),
      sums_{picture.width, picture.height, {}, {}, {}}
{
    const std::size_t pixels = picture.width * picture.height;
    sums_.place.resize(pixels);
    sums_.light.resize(pixels);
    sums_.area.resize(pixels);
    leaves_.resize(pixels);
}

void LitLayers::enter(const Geometry& geometry, std::span<const Sample> samples)
{
    const dvec3 uniform = pi * uniform_radiance(picture_.lights) * reflectance_.mean();
    std::vector<dvec3> light(samples.size(), uniform);
    in_parallel(samples.size(), [&](std::size_t k) {
        const Hit& hit = samples[k].hit;
        for (const PictureLight& each : picture_.lights) {
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
        leaves_[at] += each * reflectance_.at(cosine);
    }
}

void LitLayers::leave(std::vector<dvec3>& image, PictureWork& work) const
{
    EnteringLight entering = sums_;
    for (std::size_t k = 0; k < image.size(); ++k) {
        if (entering.area[k] == 0) continue;
        entering.place[k] /= entering.area[k];
        entering.light[k] /= entering.area[k];
    }
    work.begin("spread of light");
    const double each = work_of_spread_pixel * static_cast<double>(image.size());
    const std::vector<dvec3> light =
        spread_light(device_, entering, profile_, [&](double part) { work.advance(part * each); });
    const dvec3 whole = glm::max(pi * reflectance_.mean(), dvec3(DBL_MIN));
    for (std::size_t k = 0; k < image.size(); ++k) image[k] += leaves_[k] * light[k] / whole;
}

}  // namespace gonio

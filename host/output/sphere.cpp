// SPDX-License-Identifier: Apache-2.0
// The sphere of a contact sheet: normals, shading.
#include "output/sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>

#include "grid/local_pair.hpp"
#include "output/tone.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr dvec3 viewer{0, 0, 1};
// It leans towards the viewer, so that the frame's singular point can be seen.
constexpr dvec3 pole{0, 0.906, 0.423};
constexpr int finest = 3;  // samples along a pixel that needs more than one

struct Light {
    dvec3 towards;
    double irradiance;  ///< at normal incidence
};

/// A key light, what the ground throws back, and one from behind that shows grazing reflection.
const std::array<Light, 3>& lights()
{
    static const std::array<Light, 3> all{{{glm::normalize(dvec3(-0.5, 0.62, 0.6)), 1},
                                           {glm::normalize(dvec3(0.5, -0.62, 0.3)), 0.15},
                                           {glm::normalize(dvec3(0.85, 0.4, -0.1)), 0.3}}};
    return all;
}

/// At the rim, where a light ends, and where a highlight may be smaller than a pixel.
bool needs_subdivision(double x, double y, double pixel)
{
    const double rim = 1 - std::hypot(x, y), reach = 0.75 * pixel;
    if (std::abs(rim) < reach) return true;
    if (rim < 0) return false;
    const dvec3 normal(x, y, std::sqrt(1 - x * x - y * y));
    return std::ranges::any_of(lights(), [&](const Light& light) {
        return std::abs(glm::dot(normal, light.towards)) < reach ||
               glm::dot(normal, glm::normalize(light.towards + viewer)) > 0.998;
    });
}

std::uint32_t argb(glm::vec3 colour, float alpha)
{
    const auto byte = [](float value) { return static_cast<std::uint32_t>(255 * value + 0.5f); };
    return byte(alpha) << 24 | byte(alpha * colour.x) << 16 | byte(alpha * colour.y) << 8 |
           byte(alpha * colour.z);
}

}  // namespace

Sphere::Sphere(int size) : size_(size), coverage_(static_cast<std::size_t>(size * size))
{
    const double pixel = 2.0 / size;
    std::size_t index = 0;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column, ++index) {
            const double left = column * pixel - 1, top = 1 - row * pixel;
            const bool fine = needs_subdivision(left + pixel / 2, top - pixel / 2, pixel);
            const int count = fine ? finest : 1;
            const double step = pixel / count;
            for (int v = 0; v < count; ++v)
                for (int u = 0; u < count; ++u)
                    add_sample(index, left + (u + 0.5) * step, top - (v + 0.5) * step,
                               1.0 / (count * count));
        }
}

void Sphere::add_sample(std::size_t pixel, double x, double y, double part)
{
    const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    if (z < 1e-3) return;
    coverage_[pixel] += static_cast<float>(part);
    const dvec3 normal(x, y, z);
    for (const Light& light : lights()) {
        const double cosine = glm::dot(light.towards, normal);
        if (cosine < 1e-5) continue;
        pairs_.push_back(local_pair(light.towards, viewer, normal, pole));
        shares_.push_back({pixel, static_cast<float>(part * light.irradiance * cosine)});
    }
}

Surface Sphere::image(std::span<const glm::vec3> brdf, glm::vec3 ambient) const
{
    std::vector<glm::vec3> radiance(coverage_.size());
    for (std::size_t k = 0; k < shares_.size(); ++k)
        radiance[shares_[k].pixel] += shares_[k].weight * brdf[k];
    for (std::size_t k = 0; k < radiance.size(); ++k)
        if (coverage_[k] > 0) radiance[k] = radiance[k] / coverage_[k] + ambient;
    const float exposure = exposure_of(radiance);

    Surface surface = make_image(CAIRO_FORMAT_ARGB32, size_, size_);
    unsigned char* row = cairo_image_surface_get_data(surface.get());
    const auto width = static_cast<std::size_t>(size_);
    std::vector<std::uint32_t> pixels(width);
    for (std::size_t first = 0; first < radiance.size(); first += width) {
        for (std::size_t k = 0; k < width; ++k)
            pixels[k] = argb(to_screen(exposure * radiance[first + k]), coverage_[first + k]);
        std::memcpy(row, pixels.data(), width * sizeof(std::uint32_t));
        row += cairo_image_surface_get_stride(surface.get());
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

}  // namespace gonio

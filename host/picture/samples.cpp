// SPDX-License-Identifier: Apache-2.0
// Pinhole rays and the normals where they end.
#include "picture/samples.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>

#include "parallel.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr double least_cosine = 1e-3;  // of the viewer to a shading normal

}  // namespace

Rays::Rays(const PictureRequest& picture) : picture_(picture)
{
    const Camera& camera = picture.camera;
    forward_ = glm::normalize(camera.to - camera.from);
    const double pixel =
        2 * std::tan(glm::radians(camera.field_of_view) / 2) / static_cast<double>(picture.height);
    right_ = pixel * glm::normalize(glm::cross(forward_, camera.up));
    down_ = glm::cross(forward_, right_);
}

std::vector<Sample> Rays::meet(const Geometry& geometry, std::size_t first, std::size_t count) const
{
    std::vector<std::vector<Sample>> rows(count);
    in_parallel(count, [&](std::size_t row) {
        const double cells = static_cast<double>(picture_.samples);
        const auto from_centre = [&](std::size_t pixel, std::size_t cell, std::size_t pixels) {
            return static_cast<double>(pixel) + (static_cast<double>(cell) + 0.5) / cells -
                   static_cast<double>(pixels) / 2;
        };
        for (std::size_t x = 0; x < picture_.width; ++x)
            for (std::size_t k = 0; k < picture_.samples * picture_.samples; ++k) {
                const std::size_t y = first + row;
                const dvec3 direction = glm::normalize(
                    forward_ + from_centre(x, k % picture_.samples, picture_.width) * right_ +
                    from_centre(y, k / picture_.samples, picture_.height) * down_);
                auto hit = geometry.hit(picture_.camera.from, direction);
                if (!hit) continue;
                const double lacking = least_cosine + glm::dot(hit->normal, direction);
                if (lacking > 0) hit->normal = glm::normalize(hit->normal - lacking * direction);
                rows[row].push_back({y * picture_.width + x, *hit, -direction});
            }
    });
    std::vector<Sample> all;
    for (auto& row : rows) std::ranges::move(row, std::back_inserter(all));
    return all;
}

}  // namespace gonio

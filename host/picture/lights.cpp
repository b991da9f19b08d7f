// SPDX-License-Identifier: Apache-2.0
// Directions, distances and shadows of lights.
#include "picture/lights.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

namespace gonio {
namespace {

constexpr double least_cosine = 1e-6;  // of a light to a normal

struct Source {
    Arrival arrival;
    double distance;
};

std::optional<Source> source(const DirectionalLight& light, glm::dvec3)
{
    return Source{{light.towards, light.irradiance}, std::numeric_limits<double>::infinity()};
}

std::optional<Source> source(const PointLight& light, glm::dvec3 from)
{
    const glm::dvec3 way = light.position - from;
    const double distance = glm::length(way);
    if (distance == 0) return std::nullopt;
    return Source{{way / distance, light.intensity / (distance * distance)}, distance};
}

std::optional<Source> source(const UniformLight&, glm::dvec3)
{
    return std::nullopt;
}

glm::dvec3 colour(const DirectionalLight& light)
{
    return light.irradiance;
}

glm::dvec3 colour(const PointLight& light)
{
    return light.intensity;
}

glm::dvec3 colour(const UniformLight& light)
{
    return light.radiance;
}

}  // namespace

std::optional<Arrival> arrival(const PictureLight& light, const Hit& hit, const Geometry& geometry)
{
    const auto found =
        std::visit([&](const auto& kind) { return source(kind, hit.position); }, light);
    if (!found || glm::dot(found->arrival.towards, hit.normal) < least_cosine ||
        geometry.hides(hit, found->arrival.towards, found->distance))
        return std::nullopt;
    return found->arrival;
}

glm::dvec3 uniform_radiance(const std::vector<PictureLight>& lights)
{
    glm::dvec3 sum(0);
    for (const PictureLight& light : lights)
        if (const auto* uniform = std::get_if<UniformLight>(&light)) sum += uniform->radiance;
    return sum;
}

std::vector<PictureLight> shining(const std::vector<PictureLight>& lights)
{
    std::vector<PictureLight> bright;
    std::ranges::copy_if(lights, std::back_inserter(bright), [](const PictureLight& light) {
        return std::visit([](const auto& kind) { return colour(kind) != glm::dvec3(0); }, light);
    });
    return bright;
}

}  // namespace gonio

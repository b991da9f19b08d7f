// SPDX-License-Identifier: Apache-2.0
// Directions, distances and shadows of lights.
#include "picture/lights.hpp"

#include <glm/geometric.hpp>
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

}  // namespace gonio

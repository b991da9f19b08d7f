// SPDX-License-Identifier: Apache-2.0
// Local frames of curved surfaces.
#include "grid/local_pair.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace gonio {
namespace {

using glm::dvec3;

dvec3 east_of(dvec3 normal, dvec3 pole)
{
    const dvec3 east = glm::cross(pole, normal);
    if (glm::dot(east, east) > 1e-20) return glm::normalize(east);
    const bool along_x = std::abs(normal.x) > 0.5;
    return glm::normalize(glm::cross(along_x ? dvec3(0, 1, 0) : dvec3(1, 0, 0), normal));
}

/// theta and phi in degrees, in the frame (x, y, normal).
std::pair<double, double> angles_of(dvec3 direction, dvec3 x, dvec3 y, dvec3 normal)
{
    constexpr double degrees = 180 / std::numbers::pi;
    const double along_x = glm::dot(direction, x), along_y = glm::dot(direction, y);
    return {degrees * std::atan2(std::hypot(along_x, along_y), glm::dot(direction, normal)),
            degrees * std::atan2(along_y, along_x)};
}

}  // namespace

DirectionPair local_pair(dvec3 light, dvec3 viewer, dvec3 normal, dvec3 pole)
{
    const dvec3 east = east_of(normal, pole), north = glm::cross(normal, east);
    const auto [theta_i, phi_i] = angles_of(light, east, north, normal);
    const auto [theta_o, phi_o] = angles_of(viewer, east, north, normal);
    return {theta_i, phi_i, theta_o, phi_o};
}

}  // namespace gonio

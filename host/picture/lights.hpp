// SPDX-License-Identifier: Apache-2.0
// What of a picture's lights arrives at a point.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "gonio/picture.hpp"
#include "picture/samples.hpp"

namespace gonio {

/// Light from one direction.
struct Arrival {
    glm::dvec3 towards;     ///< unit vector to the light
    glm::dvec3 irradiance;  ///< at normal incidence
};

/// Nothing where the surface faces away from the light or a mesh hides it, and of a uniform light.
std::optional<Arrival> arrival(const PictureLight& light, const Hit& hit, const Geometry& geometry);

/// Of all uniform lights together.
glm::dvec3 uniform_radiance(const std::vector<PictureLight>& lights);

/// Those that are not black.
std::vector<PictureLight> shining(const std::vector<PictureLight>& lights);

}  // namespace gonio

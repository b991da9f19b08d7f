// SPDX-License-Identifier: Apache-2.0
// Directions at a point of a curved surface as the angles that materials are evaluated at.
#pragma once

#include <glm/vec3.hpp>

#include "gonio/grid.hpp"

namespace gonio {

/// Unit vectors to light and viewer at a surface with that unit normal, whose tangent +x runs along
/// the circles of latitude around `pole`; where that is the normal, along a direction of its own.
DirectionPair local_pair(glm::dvec3 light, glm::dvec3 viewer, glm::dvec3 normal, glm::dvec3 pole);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Directional albedo in double, by adaptive Gauss rules in the angles of the outgoing direction.
#pragma once

#include <glm/vec3.hpp>

#include "gonio/material.hpp"

namespace gonio::reference {

/// The integral of f(l, v) v.z over all v, to about `tolerance`, absolute. Panels shrink towards
/// the mirror direction and are halved until two halves agree with the whole.
double directional_albedo(const Reference& f, glm::dvec3 l, std::size_t channel, double tolerance);

/// The integral of f(l, v) l.z over all l.
double hemispherical_directional(const Reference& f, glm::dvec3 v, std::size_t channel,
                                 double tolerance);

}  // namespace gonio::reference

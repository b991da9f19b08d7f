// SPDX-License-Identifier: Apache-2.0
// Torrance & Sparrow, Theory for off-specular reflection from roughened surfaces, JOSA 57, 1967.
#include <cmath>
#include <numbers>

#include "reference/facets.hpp"
#include "reference/params.hpp"

namespace gonio::reference {

/// F G P/(4 (n.l)(n.v)), P = b exp(-c^2 delta^2) with c = 1/width and b = 1/(pi width^2).
double torrance_sparrow_1967(const torrance_sparrow_1967_params& p, glm::dvec3 l, glm::dvec3 v,
                             std::size_t channel)
{
    const Half half = half_vector(l, v);
    const double delta = std::atan2(std::hypot(half.h.x, half.h.y), half.h.z) / p.width;
    const double distribution = std::exp(-delta * delta) / (std::numbers::pi * p.width * p.width);
    return facet_reflectance(p, half.cos_d, channel) * distribution * v_cavity(l, v, half) /
           (4 * l.z * v.z);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Schlick, A fast alternative to Phong's specular model, Graphics Gems IV, 1994.
#include <glm/geometric.hpp>

#include "reference/params.hpp"

namespace gonio::reference {

/// The value t/(n - n t + t) with t = r.v; 0 where t <= 0.
double schlick(const schlick_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const glm::dvec3 r(-l.x, -l.y, l.z);
    const glm::dvec3 chord = r - v;
    const double t = glm::dot(r, v);
    if (t <= 0) return 0;
    return p.k_s[channel] * t / (p.exponent * glm::dot(chord, chord) / 2 + t);
}

}  // namespace gonio::reference

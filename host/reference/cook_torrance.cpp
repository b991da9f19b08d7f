// SPDX-License-Identifier: Apache-2.0
// Cook & Torrance, A reflectance model for computer graphics, ACM TOG 1(1), 1982, with 1/4 in place
// of 1/pi.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/facets.hpp"
#include "reference/params.hpp"

namespace gonio::reference {

/// F D G / (4 (n.l)(n.v)): Cook & Torrance 1982, normalised as in Walter et al., EGSR 2007, eq. 20.
double cook_torrance(const cook_torrance_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const glm::dvec3 h = glm::normalize(l + v);
    const double v_h = glm::dot(v, h);
    const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    const double d =
        std::exp(-tan2 / (p.m * p.m)) / (std::numbers::pi * p.m * p.m * std::pow(h.z, 4));
    const double g = std::min({1.0, 2 * h.z * v.z / v_h, 2 * h.z * l.z / v_h});
    return facet_reflectance(p, v_h, channel) * d * g / (4 * l.z * v.z);
}

}  // namespace gonio::reference

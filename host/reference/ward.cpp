// SPDX-License-Identifier: Apache-2.0
// Ward, Measuring and modeling anisotropic reflection, SIGGRAPH 1992.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

/// Ward 1992, eq. 5a, without its diffuse term: exp(-tan^2 delta (cos^2 phi / alpha_x^2 + sin^2 phi
/// / alpha_y^2)).
double ward(const ward_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const glm::dvec3 h = glm::normalize(l + v);
    const double x = h.x / p.alpha_x, y = h.y / p.alpha_y;
    const double exponent = (x * x + y * y) / (h.z * h.z);
    return p.rho_s[channel] * std::exp(-exponent) /
           (4 * std::numbers::pi * p.alpha_x * p.alpha_y * std::sqrt(l.z * v.z));
}

}  // namespace gonio::reference

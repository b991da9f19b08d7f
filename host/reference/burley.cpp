// SPDX-License-Identifier: Apache-2.0
// Burley, Physically based shading at Disney, SIGGRAPH course notes, 2012: the diffuse lobe.
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {

/// 5.3: rho/pi (1 + (F_D90 - 1)(1 - n.l)^5)(1 + (F_D90 - 1)(1 - n.v)^5) with
/// F_D90 = 1/2 + 2 roughness cos^2 theta_d.
double burley(const burley_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double cos_d = half_vector(l, v).cos_d;
    const double rise = 2 * p.roughness * cos_d * cos_d - 0.5;
    const auto factor = [rise](double cos) { return 1 + rise * std::pow(1 - cos, 5); };
    return p.rho[channel] / std::numbers::pi * factor(l.z) * factor(v.z);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Oren & Nayar, Generalization of Lambert's reflectance model, SIGGRAPH 1994.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

/// Oren & Nayar 1994, eq. 30: rho/pi (A + B max(0, cos(phi_o - phi_i)) sin alpha tan beta).
double oren_nayar(const oren_nayar_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double sigma2 = p.sigma * p.sigma;
    const double a = 1 - 0.5 * sigma2 / (sigma2 + 0.33);
    const double b = 0.45 * sigma2 / (sigma2 + 0.09);
    const double theta_i = std::atan2(std::hypot(l.x, l.y), l.z);
    const double theta_o = std::atan2(std::hypot(v.x, v.y), v.z);
    const double cos_phi = std::cos(std::atan2(v.y, v.x) - std::atan2(l.y, l.x));
    const double alpha = std::max(theta_i, theta_o), beta = std::min(theta_i, theta_o);
    return p.rho[channel] / std::numbers::pi *
           (a + b * std::max(0.0, cos_phi) * std::sin(alpha) * std::tan(beta));
}

}  // namespace gonio::reference

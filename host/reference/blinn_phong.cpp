// SPDX-License-Identifier: Apache-2.0
// Blinn, Models of light reflection for computer synthesized pictures, SIGGRAPH 1977, with unit
// albedo at normal incidence.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

/// (n.h)^n times (n + 2)(n + 4)/(8 pi (n + 2^(-n/2))): the integral of (n.h)^n cos theta_o at
/// normal incidence is its inverse.
double blinn_phong(const blinn_phong_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double n = p.exponent;
    const glm::dvec3 h = glm::normalize(l + v);
    const double log_cos = 0.5 * std::log1p(-(h.x * h.x + h.y * h.y));
    const double norm = (n + 2) * (n + 4) / (8 * std::numbers::pi * (n + std::exp2(-n / 2)));
    return p.rho_s[channel] * norm * std::exp(n * log_cos);
}

}  // namespace gonio::reference

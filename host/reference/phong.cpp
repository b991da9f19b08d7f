// SPDX-License-Identifier: Apache-2.0
// Phong, CACM 18(6), 1975, normalised by Lafortune & Willems, Report CW 197, KU Leuven, 1994.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

/// Lafortune & Willems 1994: rho_s (n + 2)/(2 pi) cos^n alpha, alpha between the mirror direction
/// and v; 0 beyond 90 degrees.
double phong(const phong_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const glm::dvec3 r(-l.x, -l.y, l.z);
    const double cos_alpha = glm::dot(r, v);
    if (cos_alpha <= 0) return 0;
    // Near the peak cos alpha = 1 - |r - v|^2 / 2 keeps the digits that the power magnifies.
    const glm::dvec3 chord = r - v;
    const double log_cos =
        cos_alpha < 0.5 ? std::log(cos_alpha) : std::log1p(-glm::dot(chord, chord) / 2);
    return p.rho_s[channel] * (p.exponent + 2) / (2 * std::numbers::pi) *
           std::exp(p.exponent * log_cos);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Phong, CACM 18(6), 1975, and its normalised form, Lafortune & Willems, Report CW 197, 1994.
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {

/// rho_s (r.v)^n, which is the value of 1975, times (n + 2)/(2 pi) in the BRDF of 1994; 0 beyond 90
/// degrees from the mirror direction r.
double phong(const phong_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double norm =
        p.form == phong_form::normalised ? (p.exponent + 2) / (2 * std::numbers::pi) : 1;
    return p.rho_s[channel] * norm * power(cosine_to_mirror(l, v), p.exponent);
}

}  // namespace gonio::reference

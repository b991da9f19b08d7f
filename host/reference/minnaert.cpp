// SPDX-License-Identifier: Apache-2.0
// Minnaert, The reciprocity principle in lunar photometry, Astrophysical Journal 93, 1941.
#include <cmath>
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

/// rho (k + 1)/(2 pi) ((n.l)(n.v))^(k - 1): the albedo at normal incidence is rho.
double minnaert(const minnaert_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    return p.rho[channel] * (p.k + 1) / (2 * std::numbers::pi) * std::pow(l.z * v.z, p.k - 1);
}

}  // namespace gonio::reference

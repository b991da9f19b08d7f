// SPDX-License-Identifier: Apache-2.0
// Beckmann & Spizzichino, The scattering of electromagnetic waves from rough surfaces, 1963, 5.3.
#include <cmath>

#include "reference/facets.hpp"
#include "reference/params.hpp"
#include "reference/wave_series.hpp"

namespace gonio::reference {

/// F cos^2 theta_d/(cos^2 theta_h (n.l)(n.v)) pi (tau/lambda)^2 W(g, b), the mean scattered power
/// as a BRDF; its mirror term is left out.
double beckmann_kirchhoff(const beckmann_kirchhoff_params& p, glm::dvec3 l, glm::dvec3 v,
                          std::size_t channel)
{
    const auto [h, cos_d] = half_vector(l, v);
    const double geometry = cos_d / h.z;
    return facet_reflectance(p, cos_d, channel) * geometry * geometry / (l.z * v.z) *
           diffracted(p, p.sigma, l.z + v.z, l, v);
}

/// F e^-g, the power of the mean field.
double beckmann_kirchhoff_specular(const beckmann_kirchhoff_params& p, glm::dvec3 l,
                                   std::size_t channel)
{
    return facet_reflectance(p, l.z, channel) * undiffracted(p, p.sigma, 2 * l.z);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Vernold & Harvey, A modified Beckmann-Kirchhoff scattering theory for nonparaxial angles, Proc.
// SPIE 3426, 1998.
#include "reference/facets.hpp"
#include "reference/params.hpp"
#include "reference/wave_series.hpp"

namespace gonio::reference {

/// F pi (tau/lambda)^2 W(g, b): the geometry factor of Beckmann & Kirchhoff is dropped, and the
/// paper's renormalisation K is 1.
double vernold_harvey(const vernold_harvey_params& p, glm::dvec3 l, glm::dvec3 v,
                      std::size_t channel)
{
    return facet_reflectance(p, half_vector(l, v).cos_d, channel) *
           diffracted(p, p.sigma, l.z + v.z, l, v);
}

/// F e^-g, as in Beckmann & Spizzichino.
double vernold_harvey_specular(const vernold_harvey_params& p, glm::dvec3 l, std::size_t channel)
{
    return facet_reflectance(p, l.z, channel) * undiffracted(p, p.sigma, 2 * l.z);
}

}  // namespace gonio::reference

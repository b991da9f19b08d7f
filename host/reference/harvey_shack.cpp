// SPDX-License-Identifier: Apache-2.0
// Harvey & Shack's transfer function of a rough surface: Krywonos, Harvey & Choi, JOSA A 28(6),
// 2011.
#include <cmath>

#include "reference/facets.hpp"
#include "reference/params.hpp"
#include "reference/wave_series.hpp"

namespace gonio::reference {
namespace {

/// Which cosines make the phase variance g: of 2011, of Harvey, Thompson & Vernold 1988, of Harvey
/// 1976.
double cosines(harvey_shack_form form, glm::dvec3 l, glm::dvec3 v)
{
    switch (form) {
        case harvey_shack_form::modified:
            return 2 * l.z;
        case harvey_shack_form::original:
            return 2;
        case harvey_shack_form::generalised:
            break;
    }
    return l.z + v.z;
}

}  // namespace

/// Q pi (tau/lambda)^2 W(g, b): the Fourier transform of exp(-g (1 - exp(-r^2/tau^2))) without its
/// mirror term, with K = 1 and Q = sqrt(F(theta_i) F(theta_o)).
double harvey_shack(const harvey_shack_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double q =
        std::sqrt(facet_reflectance(p, l.z, channel) * facet_reflectance(p, v.z, channel));
    return q * diffracted(p, p.sigma, cosines(p.form, l, v), l, v);
}

/// Q e^-g, the surface's transfer function at great distances.
double harvey_shack_specular(const harvey_shack_params& p, glm::dvec3 l, std::size_t channel)
{
    return facet_reflectance(p, l.z, channel) * undiffracted(p, p.sigma, cosines(p.form, l, l));
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Seeliger's law of 1888: single isotropic scattering in a dark, deep layer.
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

/// Hapke, Theory of reflectance and emittance spectroscopy, 2nd ed., 2012, 8.5:
/// w/(4 pi (n.l + n.v)).
double lommel_seeliger(const lommel_seeliger_params& p, glm::dvec3 l, glm::dvec3 v,
                       std::size_t channel)
{
    return p.w[channel] / (4 * std::numbers::pi * (l.z + v.z));
}

}  // namespace gonio::reference

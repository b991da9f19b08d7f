// SPDX-License-Identifier: Apache-2.0
// Lambert, Photometria, 1760: radiance does not depend on the direction.
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {

double lambert(const lambert_params& p, glm::dvec3, glm::dvec3, std::size_t channel)
{
    return p.rho[channel] / std::numbers::pi;
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Lafortune, Foo, Torrance & Greenberg, Non-linear approximation of reflectance functions,
// SIGGRAPH 1997.
#include <cmath>

#include "reference/params.hpp"

namespace gonio::reference {

/// One lobe: (c_x l.x v.x + c_y l.y v.y + c_z l.z v.z)^n, 0 where the sum is not positive.
double lafortune(const lafortune_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double sum =
        p.c_x[channel] * l.x * v.x + p.c_y[channel] * l.y * v.y + p.c_z[channel] * l.z * v.z;
    return sum > 0 ? std::pow(sum, p.exponent[channel]) : 0;
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Which symmetries of a table follow from its material, measure and grid.
#include "compute/symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {

bool is_mirrored(const Material& material, const Grid& grid)
{
    if (grid.kind != GridKind::isotropic || !material.isotropic()) return false;
    const std::vector<double>& phi = grid.axes[2].values;
    for (std::size_t k = 0; k < phi.size(); ++k)
        if (std::abs(std::remainder(phi[k] + phi[phi.size() - 1 - k], 360.0)) > 1e-9) return false;
    return phi.size() > 1;
}

bool is_reciprocal(const Material& material, Measure measure, const Grid& grid)
{
    return grid.kind == GridKind::isotropic && measure == Measure::brdf && material.isotropic() &&
           grid.axes[0].values == grid.axes[1].values &&
           std::ranges::none_of(material.lobes, [](const Lobe& lobe) {
               return (lobe.traits() & (ONE_WAY | VALUE)) != 0;
           });
}

}  // namespace gonio

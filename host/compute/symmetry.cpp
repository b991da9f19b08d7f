// SPDX-License-Identifier: Apache-2.0
// Which symmetries of a table follow from its material, measure and grid.
#include "compute/symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {
namespace {

/// Algebraic lobes come as fast as memory takes them, and to store a value twice in two places then
/// takes longer than to compute it twice: 0.5 to 1.2 times the speed was measured of most, and 1.4
/// to 2.4 of most others.
bool costs_more_than_its_store(const Material& material)
{
    return std::ranges::any_of(material.lobes,
                               [](const Lobe& lobe) { return (lobe.traits() & EXPONENTIAL) != 0; });
}

}  // namespace

bool is_mirrored(const Material& material, const Grid& grid)
{
    if (grid.kind != GridKind::isotropic || !material.isotropic() ||
        !costs_more_than_its_store(material))
        return false;
    const std::vector<double>& phi = grid.axes[2].values;
    for (std::size_t k = 0; k < phi.size(); ++k)
        if (std::abs(std::remainder(phi[k] + phi[phi.size() - 1 - k], 360.0)) > 1e-9) return false;
    return phi.size() > 1;
}

bool is_reciprocal(const Material& material, Measure measure, const Grid& grid)
{
    return costs_more_than_its_store(material) && grid.kind == GridKind::isotropic &&
           measure == Measure::brdf && material.isotropic() &&
           grid.axes[0].values == grid.axes[1].values &&
           std::ranges::none_of(material.lobes, [](const Lobe& lobe) {
               return (lobe.traits() & (ONE_WAY | VALUE)) != 0;
           });
}

}  // namespace gonio

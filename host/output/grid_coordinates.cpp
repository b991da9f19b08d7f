// SPDX-License-Identifier: Apache-2.0
// Directions to the coordinates of the three grids.
#include "output/grid_coordinates.hpp"

#include <algorithm>
#include <string>

#include "grid/rusinkiewicz.hpp"

namespace gonio {

std::optional<GridKind> grid_kind_of(const TableHeader& header)
{
    std::vector<std::string> names;
    for (std::size_t a = header.sweep_axes; a < header.axes.size(); ++a) {
        names.push_back(header.axes[a].name);
    }
    if (names == std::vector<std::string>{"theta_i", "theta_o", "delta_phi"}) {
        return GridKind::isotropic;
    }
    if (names == std::vector<std::string>{"theta_i", "phi_i", "theta_o", "phi_o"}) {
        return GridKind::anisotropic;
    }
    if (names == std::vector<std::string>{"theta_h", "theta_d", "phi_d"}) {
        return GridKind::rusinkiewicz;
    }
    return std::nullopt;
}

std::vector<double> grid_coordinates(GridKind kind, const DirectionPair& pair)
{
    if (kind == GridKind::isotropic) {
        return {pair.theta_i, pair.theta_o, pair.phi_o - pair.phi_i};
    }
    if (kind == GridKind::anisotropic) {
        return {pair.theta_i, pair.phi_i, pair.theta_o, pair.phi_o};
    }
    const auto angles = rusinkiewicz_angles(pair);
    return {angles.begin(), angles.end()};
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Samples on the horizon: nodes at exactly 90 degrees hold the limit if it is finite, else 0.
#include "compute/horizon.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {
namespace {

/// Calls found(row from `first`, channel, column) for every sample of rows [first, first + count)
/// without a finite limit.
template <class Found>
void for_each_pole(const Reference& f, const Grid& grid, std::size_t channels, std::size_t first,
                   std::size_t count, const Found& found)
{
    const bool isotropic = grid.kind == GridKind::isotropic;
    const std::vector<double> no_azimuth{0.0};
    const std::vector<double>& theta_i = grid.axes[0].values;
    const std::vector<double>& phi_i = isotropic ? no_azimuth : grid.axes[1].values;
    const std::vector<double>& theta_o = grid.axes[isotropic ? 1 : 2].values;
    const std::vector<double>& phi_o = grid.axes.back().values;
    for (std::size_t r = 0; r < count; ++r) {
        const std::size_t o = (first + r) % theta_o.size(), incoming = (first + r) / theta_o.size();
        const double i = theta_i[incoming / phi_i.size()], phi = phi_i[incoming % phi_i.size()];
        if (i != 90 && theta_o[o] != 90) continue;
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t k = 0; k < phi_o.size(); ++k)
                if (!has_limit_on_horizon(f, {i, phi, theta_o[o], phi_o[k]}, c)) found(r, c, k);
    }
}

}  // namespace

bool has_limit_on_horizon(const Reference& f, const DirectionPair& pair, std::size_t channel)
{
    const auto [l, v] = unit_vectors(pair);
    return has_limit_on_horizon(f, l, v, channel);
}

bool has_limit_on_horizon(const Reference& f, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    constexpr double horizon = 1e-10;
    if (std::min(l.z, v.z) > horizon) return true;
    // Far below every scale of a regular model (roughness 1e-5), so that only a pole still changes
    // between the two.
    auto l_lower = l, v_lower = v;
    if (l.z < horizon) l_lower.z /= 10;
    if (v.z < horizon) v_lower.z /= 10;
    const double higher = f(l, v, channel), lower = f(l_lower, v_lower, channel);
    return std::abs(lower - higher) <= 1e-3 * std::abs(higher);
}

bool touches_horizon(const Grid& grid)
{
    return grid.kind != GridKind::rusinkiewicz &&
           std::ranges::any_of(grid.axes, [](const Axis& axis) {
               return axis.name.starts_with("theta") &&
                      std::ranges::find(axis.values, 90.0) != axis.values.end();
           });
}

void clear_poles(const Reference& f, const Grid& grid, std::size_t channels, std::size_t first,
                 std::size_t count, float* values)
{
    const std::size_t length = grid.axes.back().values.size();
    for_each_pole(f, grid, channels, first, count,
                  [&](std::size_t row, std::size_t channel, std::size_t column) {
                      values[(channel * count + row) * length + column] = 0;
                  });
}

std::size_t count_poles(const Reference& f, const Grid& grid, std::size_t channels)
{
    if (!touches_horizon(grid)) return 0;
    std::size_t rows = 1, poles = 0;
    for (std::size_t k = 0; k + 1 < grid.axes.size(); ++k) rows *= grid.axes[k].values.size();
    for_each_pole(f, grid, channels, 0, rows,
                  [&](std::size_t, std::size_t, std::size_t) { ++poles; });
    return poles;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The product of one-dimensional interpolations, one for each axis.
#include "output/lookup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "gonio/errors.hpp"
#include "grid/rusinkiewicz.hpp"
#include "output/grid_coordinates.hpp"

namespace gonio {
namespace {

constexpr double sweep_tolerance = 1e-6;  // of a value of a swept axis

/// Behind the pole of an angle these azimuths are half a turn further: l or v turns about n. To
/// turn h turns the pair about n, and phi_d against h; so it does to turn l about h.
std::size_t azimuth_of(const std::vector<Axis>& axes, const std::string& angle)
{
    static const std::map<std::string, std::vector<std::string>> known = {
        {"theta_i", {"phi_i", "delta_phi"}},
        {"theta_o", {"phi_o", "delta_phi"}},
        {"theta_h", {"phi_d"}},
        {"theta_d", {"phi_d"}}};
    const auto found = known.find(angle);
    if (found != known.end()) {
        for (const auto& name : found->second) {
            const auto axis = std::ranges::find(axes, name, &Axis::name);
            if (axis != axes.end()) return static_cast<std::size_t>(axis - axes.begin());
        }
    }
    return axes.size();
}

}  // namespace

Lookup::Lookup(const Table& table, Interpolation how) : table_(table), how_(how)
{
    const auto& axes = table.header.axes;
    rusinkiewicz_ = grid_kind_of(table.header) == GridKind::rusinkiewicz;
    for (const auto& axis : axes) {
        const auto azimuth = azimuth_of(axes, axis.name);
        const bool round = azimuth < axes.size() && Stencil(axes[azimuth]).goes_round();
        stencils_.emplace_back(axis, round ? Stencil::Start::pole : Stencil::Start::end);
        azimuths_.push_back(azimuth);
    }
}

std::vector<double> Lookup::at(std::span<const double> coordinates) const
{
    const Cells cells = cells_at(coordinates);
    const double nothing = cells.empty() ? std::numeric_limits<double>::quiet_NaN() : 0;
    std::vector<double> sums(table_.values.size(), nothing);
    for (const auto& [cell, weight] : cells) {
        for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += weight * table_.values[c][cell];
    }
    return sums;
}

Lookup::Cells Lookup::cells_at(std::span<const double> coordinates) const
{
    if (coordinates.size() != stencils_.size()) {
        throw UsageError(fmt::format("a lookup needs {} coordinates, not {}", stencils_.size(),
                                     coordinates.size()));
    }
    std::vector<double> place(coordinates.begin(), coordinates.end());
    Cells cells;
    collect(place, how_, 0, 0, 1, cells);
    const auto masked = [this](const auto& cell) { return is_masked(cell.first); };
    if (rusinkiewicz_ && std::ranges::any_of(cells, masked)) {
        cells.clear();
        collect(place, Interpolation::linear, 0, 0, 1, cells);
        leave_out_masked(cells);
    }
    return cells;
}

std::vector<Stencil::Share> Lookup::shares(std::size_t axis, double coordinate,
                                           Interpolation how) const
{
    const auto& [name, unit, values, samples] = table_.header.axes[axis];
    if (!std::isfinite(coordinate)) {
        throw UsageError(fmt::format("{} is not a {}", coordinate, name));
    }
    if (axis >= table_.header.sweep_axes) return stencils_[axis].at(coordinate, how);
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::abs(values[k] - coordinate) <= sweep_tolerance * std::abs(values[k])) {
            return {{k, 1, false}};
        }
    }
    throw UsageError(fmt::format("{} = {} is not in the table, which has {:.7g}", name, coordinate,
                                 fmt::join(values, ", ")));
}

void Lookup::collect(std::vector<double>& coordinates, Interpolation how, std::size_t axis,
                     std::size_t cell, double weight, Cells& cells) const
{
    if (axis == coordinates.size()) {
        cells.emplace_back(cell, weight);
        return;
    }
    const auto size = table_.header.axes[axis].values.size();
    for (const auto& share : shares(axis, coordinates[axis], how)) {
        if (share.weight == 0) continue;
        if (share.behind_pole) coordinates[azimuths_[axis]] += 180;
        collect(coordinates, how, axis + 1, cell * size + share.sample, weight * share.weight,
                cells);
        if (share.behind_pole) coordinates[azimuths_[axis]] -= 180;
    }
}

/// Is the sample of a Rusinkiewicz grid below the horizon?
bool Lookup::is_masked(std::size_t cell) const
{
    const auto& axes = table_.header.axes;
    std::array<double, 3> angles{};
    for (std::size_t k = angles.size(); k-- > 0;) {
        const auto& values = axes[axes.size() - angles.size() + k].values;
        angles[k] = values[cell % values.size()];
        cell /= values.size();
    }
    return is_below_horizon(angles[0], angles[1], angles[2]);
}

void Lookup::leave_out_masked(Cells& cells) const
{
    std::erase_if(cells, [this](const auto& cell) { return is_masked(cell.first); });
    double sum = 0;
    for (const auto& [cell, weight] : cells) sum += weight;
    for (auto& [cell, weight] : cells) weight /= sum;
}

}  // namespace gonio

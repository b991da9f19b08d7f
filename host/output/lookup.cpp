// SPDX-License-Identifier: Apache-2.0
// The product of one-dimensional interpolations, one for each axis.
#include "output/lookup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "gonio/errors.hpp"

namespace gonio {

Lookup::Lookup(const Table& table, Interpolation how) : table_(table), how_(how)
{
    for (const auto& axis : table.header.axes) stencils_.emplace_back(axis);
}

std::vector<double> Lookup::at(std::span<const double> coordinates) const
{
    if (coordinates.size() != stencils_.size()) {
        throw UsageError(fmt::format("a lookup needs {} coordinates, not {}", stencils_.size(),
                                     coordinates.size()));
    }
    std::vector<Weights> axes;
    for (std::size_t a = 0; a < coordinates.size(); ++a) {
        axes.push_back(weights(a, coordinates[a]));
    }
    std::vector<double> sums(table_.values.size(), 0.0);
    accumulate(axes, 0, 0, 1, sums);
    return sums;
}

Lookup::Weights Lookup::weights(std::size_t axis, double coordinate) const
{
    const auto& [name, unit, values, samples] = table_.header.axes[axis];
    if (!std::isfinite(coordinate)) {
        throw UsageError(fmt::format("{} is not a {}", coordinate, name));
    }
    if (axis >= table_.header.sweep_axes) return stencils_[axis].at(coordinate, how_);
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::abs(values[k] - coordinate) <= 1e-9 * std::abs(values[k])) return {{k, 1.0}};
    }
    throw UsageError(fmt::format("{} = {} is not in the table, which has {}", name, coordinate,
                                 fmt::join(values, ", ")));
}

void Lookup::accumulate(std::span<const Weights> axes, std::size_t axis, std::size_t cell,
                        double weight, std::vector<double>& sums) const
{
    if (axis == axes.size()) {
        for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += weight * table_.values[c][cell];
        return;
    }
    const auto size = table_.header.axes[axis].values.size();
    for (const auto& [sample, part] : axes[axis]) {
        if (part != 0) accumulate(axes, axis + 1, cell * size + sample, weight * part, sums);
    }
}

}  // namespace gonio

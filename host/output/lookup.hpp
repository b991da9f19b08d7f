// SPDX-License-Identifier: Apache-2.0
// Values of a table between its samples.
#pragma once

#include <span>
#include <vector>

#include "gonio/table.hpp"
#include "output/stencil.hpp"

namespace gonio {

/// Interpolates in a table that outlives it. Swept axes are not interpolated.
class Lookup {
public:
    Lookup(const Table& table, Interpolation how);

    /// One value for each channel. coordinates: one for each axis, in its unit; beyond the ends as
    /// stencil.hpp says. A NaN in a sample that has weight gives NaN. Throws UsageError for a wrong
    /// number of coordinates, one that is not finite, and one of a swept axis that is not among its
    /// values.
    std::vector<double> at(std::span<const double> coordinates) const;

private:
    using Weights = std::vector<std::pair<std::size_t, double>>;
    Weights weights(std::size_t axis, double coordinate) const;
    void accumulate(std::span<const Weights> axes, std::size_t axis, std::size_t cell,
                    double weight, std::vector<double>& sums) const;

    const Table& table_;
    Interpolation how_;
    std::vector<Stencil> stencils_;
};

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Values of a table between its samples.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "gonio/table.hpp"
#include "output/stencil.hpp"

namespace gonio {

/// Interpolates in a table that outlives it. Swept axes are not interpolated. Near the normal, and
/// where theta_h or theta_d is small, samples from the other side of the pole take part.
class Lookup {
public:
    Lookup(const Table& table, Interpolation how);

    /// One value for each channel. coordinates: one for each axis, in its unit; beyond the ends as
    /// stencil.hpp says. On a Rusinkiewicz grid samples below the horizon do not count: beside them
    /// the others are interpolated linearly, and where there are none the value is NaN. Any other
    /// NaN in a sample that has weight gives NaN. Throws UsageError for a wrong number of
    /// coordinates, one that is not finite, and one of a swept axis that is not among its values
    /// (to 1e-6 of it).
    std::vector<double> at(std::span<const double> coordinates) const;

    /// Cells of a channel (row * row_length + column) and their weights in such a value; none where
    /// it is NaN. The table needs no values for that.
    using Cells = std::vector<std::pair<std::size_t, double>>;
    Cells cells_at(std::span<const double> coordinates) const;

private:
    std::vector<Stencil::Share> shares(std::size_t axis, double coordinate,
                                       Interpolation how) const;
    void collect(std::vector<double>& coordinates, Interpolation how, std::size_t axis,
                 std::size_t cell, double weight, Cells& cells) const;
    bool is_masked(std::size_t cell) const;
    void leave_out_masked(Cells& cells) const;

    const Table& table_;
    Interpolation how_;
    std::vector<Stencil> stencils_;
    std::vector<std::size_t> azimuths_;  // of each axis: where its pole's azimuth is, else axes()
    bool rusinkiewicz_ = false;
};

}  // namespace gonio

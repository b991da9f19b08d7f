// SPDX-License-Identifier: Apache-2.0
// What tables on larger grids will take.
#include "plan/table_cost.hpp"

#include <algorithm>

#include "plan/fitted_grid.hpp"
#include "verify/accuracy.hpp"

namespace gonio {

TableCost::TableCost(double small, const TableSeconds& taken, double cells, double channels)
    : small_(small), channels_(channels)
{
    constexpr double least = 1.0 / 16;  // of what was taken: clocks have their noise
    cell_ = std::max(taken.all - taken.checking - small, least * taken.all) / cells;
    compared_ = taken.checking / compared_of(cells);
}

double TableCost::compared_of(double cells) const
{
    return double(AccuracyCheck::compared(static_cast<std::size_t>(cells * channels_)));
}

double TableCost::cells_in(double seconds) const
{
    const double rest = std::max(0.0, seconds - small_);
    const double sampled = compared_of(most_cells);
    const double large = std::max(0.0, (rest - compared_ * sampled) / cell_);
    return compared_of(large) == sampled ? large : rest / (cell_ + channels_ * compared_);
}

}  // namespace gonio

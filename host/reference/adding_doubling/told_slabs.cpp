// SPDX-License-Identifier: Apache-2.0
// Slabs that tell how many of them are solved.
#include "reference/adding_doubling/told_slabs.hpp"

#include <algorithm>
#include <utility>

namespace gonio::reference {

ToldSlabs::ToldSlabs(double expected, AfterPart after_part)
    : expected_(expected), after_part_(std::move(after_part))
{
}

Slab ToldSlabs::operator()(const Layer& layer, const LocalDirections& directions, int mode)
{
    Slab slab = solve_slab_by_steps(layer, directions, mode, [this] { tell(); });
    const std::scoped_lock lock(guard_);
    ++solved_;
    return slab;
}

void ToldSlabs::tell()
{
    const std::scoped_lock lock(guard_);
    after_part_(std::min(solved_ / expected_, 1.0));
}

}  // namespace gonio::reference

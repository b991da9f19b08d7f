// SPDX-License-Identifier: Apache-2.0
// Samples on the horizon: nodes at exactly 90 degrees hold the limit if it is finite, else 0.
#pragma once

#include <cstddef>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/material.hpp"

namespace gonio {

/// Does the model have a finite limit as the directions at 90 degrees approach the horizon? Told
/// from the reference at two heights: a pole grows between them.
bool has_limit_on_horizon(const Reference& f, const DirectionPair& pair, std::size_t channel);

/// The same of unit_vectors() of such a pair; true above the horizon.
bool has_limit_on_horizon(const Reference& f, glm::dvec3 l, glm::dvec3 v, std::size_t channel);

/// Has the grid samples at exactly 90 degrees?
bool touches_horizon(const Grid& grid);

/// Sets cells of rows [first, first + count) without a finite limit to 0. values:
/// [channel][row][column].
void clear_poles(const Reference& f, const Grid& grid, std::size_t channels, std::size_t first,
                 std::size_t count, float* values);

/// How many samples of a whole grid have no finite limit.
std::size_t count_poles(const Reference& f, const Grid& grid, std::size_t channels);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Which symmetries of a table follow from its material, measure and grid, and save time.
#pragma once

#include "gonio/grid.hpp"
#include "gonio/material.hpp"

namespace gonio {

/// f(delta_phi) = f(-delta_phi) for every isotropic material: do the columns lie symmetric about
/// their middle?
bool is_mirrored(const Material& material, const Grid& grid);

/// f(l, v) = f(v, l) for a BRDF without one-way lobes: are theta_i and theta_o the same axis?
bool is_reciprocal(const Material& material, Measure measure, const Grid& grid);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Fits the analytic lobe of model lebedev to a table.
#pragma once

#include "gonio/material.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// Model lebedev without a residual, with k_d and k_s for each channel and one alpha: the least
/// squares of cube roots, so that the base counts beside a highlight, by Levenberg and Marquardt's
/// method over at most 4000 cells of a Rusinkiewicz table. Deterministic. Cells below the horizon
/// or without a value do not count; throws RunError if none is left.
Lobe fit_lobe(const Table& table);

}  // namespace gonio

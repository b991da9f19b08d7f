// SPDX-License-Identifier: Apache-2.0
// Grids whose counts follow from an error.
#pragma once

#include "gonio/job.hpp"

namespace gonio {

/// Directions up to here, in degrees, are what a fitted grid is right for.
inline constexpr double fitted_theta = 85;

/// Gives the job the smallest grid found on which interpolation keeps to max_error, as a fraction
/// of the largest f, for all its materials and channels; and the error that it has. Errors are the
/// largest over random pairs of directions and pairs near the mirror direction. Where 2^26 cells
/// are not enough, the error stays above. Throws UsageError for sweeps of more than 64 materials.
void fit_grid(Job& job, const GridFit& fit, double max_error);

}  // namespace gonio

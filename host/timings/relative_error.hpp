// SPDX-License-Identifier: Apache-2.0
// How far values are off that belong together.
#pragma once

#include <vector>

namespace gonio {

/// The root of the mean square of the differences, over that of the right values. Both have the
/// same size.
double relative_error(const std::vector<double>& found, const std::vector<double>& right);

/// The root of the mean of their squares.
double root_mean_square(const std::vector<double>& values);

}  // namespace gonio

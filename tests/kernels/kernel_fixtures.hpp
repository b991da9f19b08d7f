// SPDX-License-Identifier: Apache-2.0
// Runs one expression of the kernels' language over lists of numbers, at any vector width.
#pragma once

#include <string>
#include <vector>

namespace gonio {

/// The expression for each k, where x and y (`real`) are x[k] and y[k]; include: the kernel file
/// that it needs. Runs on the default device. x.size() == y.size(), a multiple of 16.
std::vector<float> on_device(const std::string& include, const std::string& expression,
                             const std::vector<float>& x, const std::vector<float>& y,
                             unsigned width = 8);

/// Floats from `from` to `to` (> from, of one sign), evenly in their bits: relatively dense
/// everywhere. count: a multiple of 16.
std::vector<float> floats_between(float from, float to, std::size_t count);

/// |got - exact| in units of the last place of a float of that size.
double ulps(float got, double exact);

}  // namespace gonio

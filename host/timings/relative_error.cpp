// SPDX-License-Identifier: Apache-2.0
// How far values are off that belong together.
#include "timings/relative_error.hpp"

#include <cmath>

namespace gonio {

double root_mean_square(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / double(values.size()));
}

double relative_error(const std::vector<double>& found, const std::vector<double>& right)
{
    std::vector<double> differences(found);
    for (std::size_t k = 0; k < found.size(); ++k) differences[k] -= right[k];
    return root_mean_square(differences) / root_mean_square(right);
}

}  // namespace gonio

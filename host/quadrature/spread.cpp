// SPDX-License-Identifier: Apache-2.0
// How wide a lobe is.
#include "quadrature/spread.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {
namespace {

constexpr double least_slope = 1e-7;
constexpr int per_decade = 8, decades = 7;

/// In one tangential direction; 1 where nothing is reflected.
double spread_along(const Reference& f, std::size_t channel, glm::dvec3 axis)
{
    const glm::dvec3 normal(0, 0, 1);
    std::array<double, static_cast<std::size_t>(per_decade) * decades> slopes{}, sums{};
    double sum = 0;
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        const double slope = least_slope * std::pow(10.0, static_cast<double>(k) / per_decade);
        const double q = 1 / (1 + slope * slope);
        const double cosine = (1 - slope * slope) * q;
        // f cos of v over the solid angle of equal steps in the slope's logarithm.
        sum += f(normal, 2 * slope * q * axis + cosine * normal, channel) * cosine * slope * slope *
               q * q;
        slopes[k] = slope;
        sums[k] = sum;
    }
    if (!(sum > 0)) return 1;
    return slopes[static_cast<std::size_t>(std::ranges::lower_bound(sums, sum / 5) - sums.begin())];
}

}  // namespace

Spread spread_of(const Material& material)
{
    const Reference f = make_reference(material, Measure::brdf);
    Spread least;
    for (std::size_t c = 0; c < material.channels(); ++c) {
        least.x = std::min(least.x, spread_along(f, c, {1, 0, 0}));
        least.y = std::min(least.y, spread_along(f, c, {0, 1, 0}));
    }
    return least;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Light that bleeds around a sphere, as an integral over the distance it goes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/profile.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

/// Intervals of Simpson's rule between kinks.
constexpr int intervals = 256;
/// From where on a Gaussian reaches less than a millionth of the radius.
constexpr double flat = 1e12;

/// max(0, n.l) on the average over the circle at `distance` (an angle) from where n.l is cos theta.
double on_circle(double theta, double distance)
{
    const double along = std::cos(theta) * std::cos(distance);
    const double across = std::sin(theta) * std::sin(distance);
    if (along >= across) return along;
    if (along <= -across) return 0;
    const double lit = std::acos(-along / across);
    return (along * lit + across * std::sin(lit)) / pi;
}

/// Between two angles: the variable grows with the root of the distance to either end, where the
/// circle's average has kinks like those of roots.
double simpson(double from, double to, double theta, double falloff)
{
    double sum = 0;
    for (int k = 0; k <= intervals; ++k) {
        const double t = static_cast<double>(k) / intervals;
        const double distance = from + (to - from) * t * t * (3 - 2 * t);
        const double speed = (to - from) * 6 * t * (1 - t);
        const double half = std::sin(distance / 2);
        const double term = speed * std::sin(distance) * std::exp(-falloff * 2 * half * half) *
                            on_circle(theta, distance);
        sum += (k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2) * term;
    }
    return sum / (3 * intervals);
}

/// One Gaussian of variance v = radius^2/falloff.
double spread(double theta, double falloff)
{
    if (falloff > flat) return std::max(0.0, std::cos(theta));
    // exp(-falloff (1 - cos)) is nothing beyond this angle.
    const double reach = falloff > 20 ? 2 * std::asin(std::sqrt(20 / falloff)) : pi;
    std::vector<double> ends = {0, std::abs(pi / 2 - theta), 1.5 * pi - theta, reach};
    for (double& end : ends) end = std::clamp(end, 0.0, reach);
    std::ranges::sort(ends);
    double sum = 0;
    for (std::size_t k = 1; k < ends.size(); ++k)
        if (ends[k] > ends[k - 1]) sum += simpson(ends[k - 1], ends[k], theta, falloff);
    return sum * falloff / -std::expm1(-2 * falloff);
}

}  // namespace

std::array<double, 3> around_a_sphere(const SumOfGaussians& profile, double n_dot_l,
                                      double curvature)
{
    const double theta = std::acos(std::clamp(n_dot_l, -1.0, 1.0));
    std::array<double, 3> light{}, all{};
    for (std::size_t k = 0; k < profile.variances.size(); ++k) {
        const double falloff = 1 / (curvature * curvature * profile.variances[k]);
        const double part = spread(theta, falloff);
        // Less of a wide Gaussian is on the sphere than on a plane.
        const double on_sphere = -std::expm1(-2 * falloff);
        for (std::size_t c = 0; c < 3; ++c) {
            light[c] += profile.weights[k][c] * on_sphere * part;
            all[c] += profile.weights[k][c] * on_sphere;
        }
    }
    for (std::size_t c = 0; c < 3; ++c) light[c] = all[c] > 0 ? light[c] / all[c] : 0;
    return light;
}

}  // namespace gonio

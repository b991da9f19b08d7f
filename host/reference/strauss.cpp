// SPDX-License-Identifier: Apache-2.0
// Strauss, A realistic lighting model for computer animators, IEEE CG&A 10(6), 1990.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

/// An angle to the normal as a part x of 90 degrees, and 1 - x.
struct Part {
    double x, rest;
};

Part part_of_right_angle(glm::dvec3 w)
{
    const double sin = std::hypot(w.x, w.y), right = std::numbers::pi / 2;
    return {std::atan2(sin, w.z) / right, std::atan2(w.z, sin) / right};
}

/// F(x) = (1/(x - k)^2 - 1/k^2)/(1/(1 - k)^2 - 1/k^2), k = 1.12: like Fresnel's, 0 at 0 and 1 at 1.
double fresnel_like(Part part)
{
    constexpr double k = 1.12;
    const auto rise = [](double x) { return x * (2 * k - x) / (k * k * (x - k) * (x - k)); };
    return rise(part.x) / rise(1);
}

/// G(x) = (1/(1 - k)^2 - 1/(x - k)^2)/(1/(1 - k)^2 - 1/k^2), k = 1.01: shadowing, 1 at 0 and 0
/// at 1.
double shadowing(Part part)
{
    constexpr double k = 1.01;
    const auto fall = [](double x, double rest) {
        return rest * (2 * k - 1 - x) / ((1 - k) * (1 - k) * (x - k) * (x - k));
    };
    return fall(part.x, part.rest) / fall(0, 1);
}

}  // namespace

/// The value Q_d + Q_s: Q_d = n.l (1 - m s) r_d c with r_d = (1 - s^3)(1 - t), and
/// Q_s = (r.v)^(3/(1 - s)) r_j c_s with r_n = 1 - t - r_d = s^3 (1 - t), j = F(l) G(l) G(v),
/// r_j = min(1, r_n + (r_n + 0.1) j), c_s = 1 + m (1 - F(l))(c - 1).
double strauss(const strauss_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double s = p.smoothness, m = p.metalness, color = p.c[channel];
    const double r_n = s * s * s * (1 - p.transparency), r_d = 1 - p.transparency - r_n;
    const double diffuse = l.z * (1 - m * s) * r_d * color;

    const Part light = part_of_right_angle(l), viewer = part_of_right_angle(v);
    const double f = fresnel_like(light), j = f * shadowing(light) * shadowing(viewer);
    const double r_j = std::min(1.0, r_n + (r_n + 0.1) * j);
    const double c_s = 1 + m * (1 - f) * (color - 1);
    return diffuse + power(cosine_to_mirror(l, v), 3 / (1 - s)) * r_j * c_s;
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Rusinkiewicz's angles of a pair of directions (A new change of variables for efficient BRDF
// representation, EGWR 1998), in degrees.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "gonio/grid.hpp"

namespace gonio {

/// theta_h, theta_d, phi_d. The azimuth of h is left out: an isotropic material does not see it.
/// phi_d is -180 to 180, and 0 where it is undefined. Errors: a few ulp also of small angles.
inline std::array<double, 3> rusinkiewicz_angles(const DirectionPair& pair)
{
    constexpr double degrees = 180 / std::numbers::pi;
    const auto [l, v] = unit_vectors(pair);
    const glm::dvec3 sum = l + v, difference = l - v;
    const double across = std::hypot(sum.x, sum.y), length = std::hypot(across, sum.z);
    const double apart = std::hypot(difference.x, difference.y, difference.z);
    // The frame of h: x falls along its meridian, y is horizontal; l - v has no part along h.
    const double cos_phi = across > 0 ? sum.x / across : 1,
                 sin_phi = across > 0 ? sum.y / across : 0;
    const double outward = difference.x * cos_phi + difference.y * sin_phi;
    const double x = (outward * sum.z - difference.z * across) / length;
    const double y = difference.y * cos_phi - difference.x * sin_phi;
    return {std::atan2(across, sum.z) * degrees, std::atan2(apart, length) * degrees,
            std::atan2(y, x) * degrees};
}

/// Is light or viewer below the horizon? Their cosines are
/// cos theta_h cos theta_d -+ sin theta_h sin theta_d cos phi_d (section 3).
inline bool is_below_horizon(double theta_h, double theta_d, double phi_d)
{
    constexpr double radian = std::numbers::pi / 180;
    const double even = std::cos(theta_h * radian) * std::cos(theta_d * radian);
    const double odd = std::sin(theta_h * radian) * std::sin(theta_d * radian);
    return even - odd * std::abs(std::cos(phi_d * radian)) <= rusinkiewicz_horizon;
}

}  // namespace gonio

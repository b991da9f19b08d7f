// SPDX-License-Identifier: Apache-2.0
// Trigonometry of angles in degrees, relatively accurate also where the result is small, and
// numbers split into two floats.
#pragma once

#include <cmath>
#include <numbers>

namespace gonio {

/// Height above the horizon, in degrees, at which a direction of exactly 90 degrees is evaluated:
/// far below what any roughness of the catalogue resolves, far above where float32 overflows when
/// it is divided by twice.
inline constexpr double horizon_height = 1e-9;

/// sin of degrees + 90 quarters; the reduction is exact, so that zeros are exact and their
/// neighbours have all digits.
inline double sine_of_degrees(double degrees, int quarters = 0)
{
    const double turn = std::remainder(degrees, 360.0);
    const double nearest = std::nearbyint(turn / 90);
    const double rest = (turn - 90 * nearest) * (std::numbers::pi / 180);
    switch ((static_cast<int>(nearest) + quarters) & 3) {
        case 0:
            return std::sin(rest);
        case 1:
            return std::cos(rest);
        case 2:
            return -std::sin(rest);
        default:
            return -std::cos(rest);
    }
}

inline double cosine_of_degrees(double degrees)
{
    return sine_of_degrees(degrees, 1);
}

/// A direction's angle from the normal, 0 to 90 degrees, and what sums and differences of such
/// angles need.
struct PolarAngle {
    double sine, cosine, half_sine, half_cosine;
    double half_complement_sine, half_complement_cosine;  ///< of (90 degrees - theta) / 2

    explicit PolarAngle(double degrees)
    {
        const double complement = degrees == 90 ? horizon_height : 90 - degrees;
        sine = cosine_of_degrees(complement);
        cosine = sine_of_degrees(complement);
        half_sine = sine_of_degrees(degrees / 2);
        half_cosine = cosine_of_degrees(degrees / 2);
        half_complement_sine = sine_of_degrees(complement / 2);
        half_complement_cosine = cosine_of_degrees(complement / 2);
    }
};

inline float high_part(double x)
{
    return static_cast<float>(x);
}
inline float low_part(double x)
{
    return static_cast<float>(x - static_cast<double>(high_part(x)));
}

}  // namespace gonio

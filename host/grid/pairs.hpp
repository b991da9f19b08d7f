// SPDX-License-Identifier: Apache-2.0
// The quantities of kernels/directions/directions.cl for one pair of directions, in double and
// without cancellation.
#pragma once

#include "gonio/grid.hpp"
#include "grid/angles.hpp"

namespace gonio {

/// What two angles from the normal give together; difference and sum are of theta_i and theta_o.
struct PolarPair {
    double tan2_half_difference, tan2_half_sum, cos2_half_sum, sin2_half_difference;
    double cos_cos, sin_sin;

    PolarPair(const PolarAngle& i, const PolarAngle& o)
    {
        const double sin_half_difference =
            i.half_sine * o.half_cosine - i.half_cosine * o.half_sine;
        const double cos_half_difference =
            i.half_cosine * o.half_cosine + i.half_sine * o.half_sine;
        const double sin_half_sum = i.half_sine * o.half_cosine + i.half_cosine * o.half_sine;
        // cos((theta_i + theta_o)/2) through the complements: a sum also at double grazing.
        const double cos_half_sum = i.half_complement_sine * o.half_complement_cosine +
                                    i.half_complement_cosine * o.half_complement_sine;
        const auto square = [](double x) { return x * x; };
        tan2_half_difference = square(sin_half_difference / cos_half_difference);
        tan2_half_sum = square(sin_half_sum / cos_half_sum);
        cos2_half_sum = square(cos_half_sum);
        sin2_half_difference = square(sin_half_difference);
        cos_cos = i.cosine * o.cosine;
        sin_sin = i.sine * o.sine;
    }
};

/// What two azimuths give together; delta = phi_o - phi_i in degrees. Even in delta to the last
/// bit.
struct AzimuthPair {
    double cos2_half, sin2_half, cosine;

    explicit AzimuthPair(double delta)
    {
        const double folded = std::abs(std::remainder(delta, 360.0));
        const double half_sine = sine_of_degrees(folded / 2);
        const double half_cosine = sine_of_degrees((180 - folded) / 2);
        cos2_half = half_cosine * half_cosine;
        sin2_half = half_sine * half_sine;
        cosine = cosine_of_degrees(folded);
    }
};

}  // namespace gonio

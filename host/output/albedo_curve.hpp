// SPDX-License-Identifier: Apache-2.0
// The directional albedo of a material against the angle of the light, for plots.
#pragma once

#include <vector>

#include "gonio/material.hpp"

namespace gonio {

/// A point of the curve. albedo: one value for each channel, 1.
struct AlbedoPoint {
    double theta_i;  ///< degrees
    std::vector<double> albedo;
};

/// The integral of f cos theta_o over all viewers in double, for light along x at 0 to 89 degrees,
/// by Gauss-Legendre rules whose nodes crowd at the mirror direction. Relative errors: below 1e-4
/// from a roughness of 1e-3, a few percent at 1e-5. Lobes are symmetric to the x-z plane.
std::vector<AlbedoPoint> albedo_curve(const Material& material);

}  // namespace gonio

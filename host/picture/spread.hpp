// SPDX-License-Identifier: Apache-2.0
// Light that enters a surface at one pixel of a picture and leaves at another.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/profile.hpp"

namespace gonio {

/// What a picture shows of a surface, pixel by pixel. Where area is 0 there is none of it.
struct EnteringLight {
    std::size_t width = 0, height = 0;
    std::vector<glm::dvec3> place;  ///< mm
    std::vector<glm::dvec3> light;  ///< R, G, B that enter, per area
    std::vector<double> area;       ///< mm^2
};

/// The light at each pixel after it has spread: for each Gaussian the mean over the pixels up to
/// three standard deviations away, weighted by it at their distance in space and by their areas,
/// and the sum of these by its weights, which are scaled to add up to 1. Even light stays as it is.
/// Surface that the picture does not show gives no light. Wide Gaussians see blocks of pixels whose
/// sides are up to half a standard deviation long.
/// `after_each` is called after each Gaussian with the part that it was; what it throws ends the
/// work.
std::vector<glm::dvec3> spread_light(
    const Device& device, const EnteringLight& entering, const SumOfGaussians& profile,
    const std::function<void(double part)>& after_each = [](double) {});

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Light that enters skin in a picture, spreads, and leaves it.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "gonio/picture.hpp"
#include "picture/samples.hpp"
#include "picture/skin_reflectance.hpp"
#include "picture/spread.hpp"

namespace gonio {

class SkinLayers {
public:
    SkinLayers(const Device& device, const PictureRequest& picture, const Skin& skin,
               const Material& surface);

    /// Takes what enters at each sample.
    void enter(const Geometry& geometry, std::span<const Sample> samples);

    /// Adds to a picture what leaves of all that has entered, towards the viewer.
    void leave(std::vector<glm::dvec3>& image) const;

private:
    Device device_;
    const PictureRequest& picture_;
    SkinReflectance reflectance_;
    SumOfGaussians profile_;
    EnteringLight sums_;              ///< places and light times area
    std::vector<glm::dvec3> leaves_;  ///< at each pixel: radiance by light
};

}  // namespace gonio

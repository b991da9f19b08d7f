// SPDX-License-Identifier: Apache-2.0
// Light that enters layers in a picture, spreads, and leaves them.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "gonio/picture.hpp"
#include "picture/layer_reflectance.hpp"
#include "picture/picture_material.hpp"
#include "picture/samples.hpp"
#include "picture/spread.hpp"
#include "picture/work.hpp"

namespace gonio {

class LitLayers {
public:
    LitLayers(const Device& device, const PictureRequest& picture, const PictureMaterial& material,
              PictureWork& work);

    /// Takes what enters at each sample.
    void enter(const Geometry& geometry, std::span<const Sample> samples);

    /// Adds to a picture what leaves of all that has entered, towards the viewer.
    void leave(std::vector<glm::dvec3>& image, PictureWork& work) const;

private:
    Device device_;
    const PictureRequest& picture_;
    LayerReflectance reflectance_;
    SumOfGaussians profile_;
    EnteringLight sums_;              ///< places and light times area
    std::vector<glm::dvec3> leaves_;  ///< at each pixel: radiance by light
};

}  // namespace gonio

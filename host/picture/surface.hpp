// SPDX-License-Identifier: Apache-2.0
// Materials that are sums of lobes, under a picture's lights.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "gonio/material.hpp"
#include "gonio/picture.hpp"
#include "picture/samples.hpp"

namespace gonio {

/// One material of a picture. It builds what the lights need of it, at its first sample.
class Surface {
public:
    Surface(const Device& device, const PictureRequest& picture, Material material);

    /// Radiance towards the viewer at each sample.
    std::vector<glm::dvec3> radiance(const Geometry& geometry, std::span<const Sample> samples);

private:
    /// Reflected radiance by that of the uniform light, [azimuth][cosine], of the viewer.
    glm::dvec3 uniform_reflectance(const Sample& sample) const;

    Device device_;
    const PictureRequest& picture_;
    Material material_;
    glm::dvec3 uniform_light_{0};
    std::size_t azimuths_ = 1;
    std::vector<glm::dvec3> uniform_;  ///< empty without a uniform light
};

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Materials that are sums of lobes, under a picture's lights.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "gonio/material.hpp"
#include "gonio/picture.hpp"
#include "picture/samples.hpp"
#include "picture/surface_albedo.hpp"

namespace gonio {

/// One material of a picture. It builds what the lights need of it, and nothing without lobes.
class Surface {
public:
    Surface(const Device& device, const PictureRequest& picture, Material material);

    /// Radiance towards the viewer at each sample.
    std::vector<glm::dvec3> radiance(const Geometry& geometry,
                                     std::span<const Sample> samples) const;

private:
    /// Adds what comes from single directions.
    void add_reflected(const Geometry& geometry, std::span<const Sample> samples,
                       std::vector<glm::dvec3>& radiance) const;

    Device device_;
    const PictureRequest& picture_;
    Material material_;
    glm::dvec3 uniform_light_{0};
    std::optional<SurfaceAlbedo> albedo_;  ///< with a uniform light
};

}  // namespace gonio

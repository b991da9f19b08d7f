// SPDX-License-Identifier: Apache-2.0
// The rays of a picture.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "gonio/picture.hpp"
#include "picture/geometry.hpp"

namespace gonio {

/// What one ray through a pixel has met.
struct Sample {
    std::size_t pixel = 0;  ///< counted row by row
    Hit hit;
    glm::dvec3 viewer;  ///< unit vector to the camera
};

/// Rays of a pinhole: `samples` x `samples` in each pixel, in the middles of its cells.
class Rays {
public:
    explicit Rays(const PictureRequest& picture);

    /// What those of the rows [first, first + count) meet, in their order; a normal that faces away
    /// from the viewer is turned until he is just above its horizon.
    std::vector<Sample> meet(const Geometry& geometry, std::size_t first, std::size_t count) const;

private:
    const PictureRequest& picture_;
    glm::dvec3 forward_, right_, down_;  ///< to the picture's centre; along a pixel, at distance 1
};

}  // namespace gonio

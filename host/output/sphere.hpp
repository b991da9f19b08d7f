// SPDX-License-Identifier: Apache-2.0
// A lit sphere: which pairs of directions it needs, and the picture that their values make.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "gonio/grid.hpp"
#include "output/canvas.hpp"

namespace gonio {

/// A sphere seen from far away under three distant lights: the brightest at the upper left, faint
/// ones from below and from behind at the right. Its tangent x runs along the circles of latitude.
class Sphere {
public:
    /// size: its diameter in pixels.
    explicit Sphere(int size);

    /// What to evaluate the BRDF at, in degrees.
    const std::vector<DirectionPair>& pairs() const { return pairs_; }

    /// brdf[k] belongs to pairs()[k], linear sRGB, in 1/sr. The image is size x size, transparent
    /// around the sphere, and exposed for what it shows. ambient: a radiance to add everywhere.
    Surface image(std::span<const glm::vec3> brdf, glm::vec3 ambient) const;

private:
    /// What a pair adds to a pixel: the BRDF times this.
    struct Share {
        std::size_t pixel;
        float weight;
    };
    /// x, y: the normal's, in [-1, 1]; part: of the pixel.
    void add_sample(std::size_t pixel, double x, double y, double part);

    int size_;
    std::vector<DirectionPair> pairs_;
    std::vector<Share> shares_;    ///< one per pair
    std::vector<float> coverage_;  ///< of each pixel, 0 to 1
};

}  // namespace gonio

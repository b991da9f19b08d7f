// SPDX-License-Identifier: Apache-2.0
// Where rays meet meshes.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "picture/mesh.hpp"

namespace gonio {

/// A point of a mesh that a ray has met.
struct Hit {
    std::size_t mesh = 0;
    glm::dvec3 position;
    glm::dvec3 lifted;  ///< the position on the curved surface that the corners' normals tell of
    glm::dvec3 normal;  ///< interpolated, on the side of the ray's origin
};

/// Meshes ready for rays. Its members may be called by several threads.
class Geometry {
public:
    explicit Geometry(std::vector<Mesh> meshes);
    ~Geometry();
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    /// The nearest point along a ray; direction: a unit vector.
    std::optional<Hit> hit(glm::dvec3 origin, glm::dvec3 direction) const;

    /// Whether a mesh stands between a hit and what is `distance` away in a direction.
    bool hides(const Hit& hit, glm::dvec3 direction, double distance) const;

private:
    struct Scene;
    std::vector<Mesh> meshes_;
    std::unique_ptr<Scene> scene_;
    double near_ = 0;  ///< shadow rays meet nothing up to here: what rounding moves a hit by
};

}  // namespace gonio

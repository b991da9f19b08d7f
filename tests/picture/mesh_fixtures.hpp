// SPDX-License-Identifier: Apache-2.0
// OBJ files and the pictures of them.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>

#include "gonio/device.hpp"
#include "gonio/picture.hpp"
#include "gonio/table.hpp"

namespace gonio::test {

/// A folder of its own for the files of a test, gone at its end.
class MeshFolder {
public:
    MeshFolder();
    ~MeshFolder();
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;

    /// Writes a mesh.
    void add(const std::string& name, const std::string& obj) const;

    /// The picture of a scene, given as text, whose meshes are here.
    Table picture(const Device& device, const std::string& scene) const;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// A unit sphere, or the cap of it around +z up to `angle` (degrees), in rings x sectors of quads,
/// with normals unless they are left out.
std::string sphere_obj(int rings, int sectors, double angle = 180, bool normals = true);

glm::dvec3 pixel_of(const Table& picture, std::size_t x, std::size_t y);

}  // namespace gonio::test

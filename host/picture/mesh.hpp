// SPDX-License-Identifier: Apache-2.0
// Triangles of OBJ files.
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

namespace gonio {

/// Triangles with a unit normal at each corner.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<std::array<unsigned, 3>> triangles;  ///< indices into positions
    std::vector<std::array<glm::dvec3, 3>> normals;  ///< of each triangle's corners
};

/// Reads the text of an OBJ file: polygons are cut into triangles; corners without a normal get the
/// average over the triangles at their vertex, weighted by area. Triangles without an area are left
/// out. Throws UsageError with `file` and the line for what is no number, for vertices and normals
/// that are not there, and without a line if there is no face.
Mesh parse_mesh(std::string_view text, std::string_view file);

/// The same for a file.
Mesh read_mesh(const std::filesystem::path& path);

}  // namespace gonio

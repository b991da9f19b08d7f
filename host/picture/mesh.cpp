// SPDX-License-Identifier: Apache-2.0
// OBJ files by tinyobjloader, which takes bad numbers for 0 and knows no lines: a first pass finds
// both.
#include "picture/mesh.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <glm/geometric.hpp>
#include <span>
#include <sstream>
#include <system_error>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

/// Reads an OBJ file line by line and refuses the first one that is wrong.
class LineCheck {
public:
    explicit LineCheck(std::string_view file) : file_(file)
    {
        callback_.vertex_cb = [](void* self, float, float, float, float) {
            static_cast<LineCheck*>(self)->count("v", static_cast<LineCheck*>(self)->vertices_);
        };
        callback_.normal_cb = [](void* self, float, float, float) {
            static_cast<LineCheck*>(self)->count("vn", static_cast<LineCheck*>(self)->normals_);
        };
        callback_.index_cb = [](void* self, tinyobj::index_t* corners, int number) {
            static_cast<LineCheck*>(self)->check_face({corners, static_cast<std::size_t>(number)});
        };
    }

    void read(const std::string& line)
    {
        line_ = line;
        ++number_;
        std::istringstream stream(line);
        tinyobj::LoadObjWithCallback(stream, callback_, this);
    }

private:
    [[noreturn]] void fail(const std::string& message) const
    {
        throw UsageError(fmt::format("{}:{}: {}", file_, number_, message));
    }

    void count(std::string_view key, int& counter)
    {
        std::istringstream words(line_);
        std::string first;
        float x = 0, y = 0, z = 0;
        if (!(words >> first >> x >> y >> z))
            fail(fmt::format("`{}` needs three finite numbers", key));
        ++counter;
    }

    void check_index(std::string_view what, int index, int there) const
    {
        if (index == 0 || index > there || index < -there)
            fail(fmt::format("{} {}; up to this line there are {}", what, index, there));
    }

    void check_face(std::span<const tinyobj::index_t> corners)
    {
        if (corners.size() < 3)
            fail(fmt::format("a face of {} corners; allowed are 3 and more", corners.size()));
        for (const tinyobj::index_t& corner : corners) {
            check_index("vertex", corner.vertex_index, vertices_);
            if (corner.normal_index != 0) check_index("normal", corner.normal_index, normals_);
        }
    }

    std::string_view file_;
    tinyobj::callback_t callback_;
    std::string line_;
    std::size_t number_ = 0;
    int vertices_ = 0, normals_ = 0;
};

/// Twice the triangle's area along its normal.
glm::dvec3 area_normal(const Mesh& mesh, const std::array<unsigned, 3>& triangle)
{
    const glm::dvec3 a = mesh.positions[triangle[0]];
    return glm::cross(glm::dvec3(mesh.positions[triangle[1]]) - a,
                      glm::dvec3(mesh.positions[triangle[2]]) - a);
}

glm::dvec3 unit_or_zero(glm::dvec3 vector)
{
    const double length = glm::length(vector);
    return length > 0 ? vector / length : glm::dvec3(0);
}

std::vector<glm::dvec3> average_normals(const Mesh& mesh)
{
    std::vector<glm::dvec3> sums(mesh.positions.size());
    for (const auto& triangle : mesh.triangles)
        for (const unsigned corner : triangle) sums[corner] += area_normal(mesh, triangle);
    for (glm::dvec3& sum : sums) sum = unit_or_zero(sum);
    return sums;
}

glm::vec3 triple(const std::vector<float>& numbers, int index)
{
    const float* at = numbers.data() + 3 * static_cast<std::ptrdiff_t>(index);
    return {at[0], at[1], at[2]};
}

/// Rounding alone decides where a thinner triangle faces.
bool has_area(const Mesh& mesh, const std::array<unsigned, 3>& triangle)
{
    const auto edge = [&](std::size_t from, std::size_t to) {
        return glm::distance(mesh.positions[triangle[from]], mesh.positions[triangle[to]]);
    };
    const auto longest = static_cast<double>(std::max({edge(0, 1), edge(1, 2), edge(2, 0)}));
    return glm::length(area_normal(mesh, triangle)) > 1e-6 * longest * longest;
}

Mesh mesh_of(const tinyobj::attrib_t& attributes, const std::vector<tinyobj::shape_t>& shapes)
{
    Mesh mesh;
    for (std::size_t k = 0; k < attributes.vertices.size() / 3; ++k)
        mesh.positions.push_back(triple(attributes.vertices, static_cast<int>(k)));
    std::vector<std::array<int, 3>> given;  // normals
    for (const tinyobj::shape_t& shape : shapes)
        for (std::size_t k = 0; k + 2 < shape.mesh.indices.size(); k += 3) {
            const tinyobj::index_t* corners = &shape.mesh.indices[k];
            const std::array triangle{static_cast<unsigned>(corners[0].vertex_index),
                                      static_cast<unsigned>(corners[1].vertex_index),
                                      static_cast<unsigned>(corners[2].vertex_index)};
            if (!has_area(mesh, triangle)) continue;
            mesh.triangles.push_back(triangle);
            given.push_back(
                {corners[0].normal_index, corners[1].normal_index, corners[2].normal_index});
        }
    const std::vector<glm::dvec3> averages = average_normals(mesh);
    for (std::size_t k = 0; k < given.size(); ++k) {
        auto& normals = mesh.normals.emplace_back();
        for (std::size_t c = 0; c < 3; ++c)
            normals[c] = given[k][c] < 0 ? averages[mesh.triangles[k][c]]
                                         : unit_or_zero(triple(attributes.normals, given[k][c]));
    }
    return mesh;
}

}  // namespace

Mesh parse_mesh(std::string_view text, std::string_view file)
{
    std::istringstream lines{std::string(text)}, whole{std::string(text)};
    LineCheck check(file);
    for (std::string line; std::getline(lines, line);) check.read(line);

    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warnings, errors;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warnings, &errors, &whole))
        throw UsageError(fmt::format("{}: {}", file, errors));
    Mesh mesh = mesh_of(attributes, shapes);
    if (mesh.triangles.empty())
        throw UsageError(fmt::format("{}: there is no face with an area in it", file));
    return mesh;
}

Mesh read_mesh(const std::filesystem::path& path)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file || errno != 0)
        throw UsageError(fmt::format("{}: cannot be read: {}", path.string(),
                                     std::generic_category().message(errno)));
    return parse_mesh(text.str(), path.string());
}

}  // namespace gonio

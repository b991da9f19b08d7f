// SPDX-License-Identifier: Apache-2.0
// OBJ files and the pictures of them.
#include "picture/mesh_fixtures.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "gonio/scene.hpp"

namespace gonio::test {

MeshFolder::MeshFolder()
    : path_(std::filesystem::temp_directory_path() / fmt::format("gonio-meshes-{}", getpid()))
{
    std::filesystem::create_directories(path_);
}

MeshFolder::~MeshFolder()
{
    std::filesystem::remove_all(path_);
}

void MeshFolder::add(const std::string& name, const std::string& obj) const
{
    std::ofstream(path_ / name) << obj;
}

Table MeshFolder::picture(const Device& device, const std::string& scene) const
{
    const Scene read = parse_scene(scene, (path_ / "scene.toml").string());
    return make_picture(device, *read.picture, read.materials);
}

std::string sphere_obj(int rings, int sectors, double angle, bool normals)
{
    std::string text;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double theta = angle / 180 * std::numbers::pi * r / rings;
            const double sine = std::abs(std::sin(theta)) < 1e-9 ? 0 : std::sin(theta);
            const double phi = 2 * std::numbers::pi * s / sectors;
            const auto numbers = fmt::format("{:.9g} {:.9g} {:.9g}\n", sine * std::cos(phi),
                                             sine * std::sin(phi), std::cos(theta));
            text += "v " + numbers;
            if (normals) text += "vn " + numbers;
        }
    const auto corner = [&](int r, int s) {
        const int index = r * sectors + s % sectors + 1;
        return normals ? fmt::format(" {0}//{0}", index) : fmt::format(" {}", index);
    };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s)
            text += fmt::format("f{}{}{}{}\n", corner(r, s), corner(r + 1, s), corner(r + 1, s + 1),
                                corner(r, s + 1));
    return text;
}

glm::dvec3 pixel_of(const Table& picture, std::size_t x, std::size_t y)
{
    const std::size_t k = y * picture.header.row_length() + x;
    return {picture.values[0][k], picture.values[1][k], picture.values[2][k]};
}

}  // namespace gonio::test

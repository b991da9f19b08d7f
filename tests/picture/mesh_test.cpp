// SPDX-License-Identifier: Apache-2.0
// Meshes: what is read, and which line is refused.
#include "picture/mesh.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr auto corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string refusal(const std::string& text)
{
    try {
        parse_mesh(text, "a.obj");
    } catch (const UsageError& error) {
        return error.what();
    }
    return {};
}

TEST(Mesh, CutsPolygonsIntoTriangles)
{
    const Mesh mesh = parse_mesh(std::string("# four\r\n") + corners + "f 1 2 3 4\r\n", "a.obj");
    EXPECT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    for (const auto& normals : mesh.normals)
        for (const dvec3 normal : normals) EXPECT_EQ(normal, dvec3(0, 0, 1));
}

TEST(Mesh, TakesNormalsOfTheFileAtAnyLength)
{
    const Mesh mesh =
        parse_mesh(std::string(corners) + "vn 0 0 -3\nvn 4 0 0\nf 1//1 2//-1 3//2\n", "a.obj");
    EXPECT_EQ(mesh.normals[0][0], dvec3(0, 0, -1));
    EXPECT_EQ(mesh.normals[0][1], dvec3(1, 0, 0));
}

// At vertex 1 meet a triangle of area 1/2 that faces +z and one of area 3/2 that faces +x.
TEST(Mesh, WeightsMissingNormalsByArea)
{
    const Mesh mesh = parse_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 3\nf 1 2 3\nf 1 3 4\n", "a.obj");
    const dvec3 mean = glm::normalize(dvec3(3, 0, 1));
    EXPECT_LT(glm::length(mesh.normals[0][0] - mean), 1e-12);
    EXPECT_EQ(mesh.normals[0][0], mesh.normals[1][0]);
    EXPECT_EQ(mesh.normals[0][1], dvec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1][2], dvec3(1, 0, 0));
}

TEST(Mesh, LeavesOutTrianglesWithoutAnArea)
{
    const Mesh mesh =
        parse_mesh(std::string(corners) + "v 2 0 1e-9\nf 4 4 4\nf 1 2 3\nf 1 2 5\n", "a.obj");
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<unsigned, 3>>{{0, 1, 2}}));
    EXPECT_EQ(mesh.normals.size(), 1u);
}

TEST(Mesh, TellsTheLineThatIsWrong)
{
    EXPECT_EQ(refusal("v 0 0 0\nv 1 x 0\n"), "a.obj:2: `v` needs three finite numbers");
    EXPECT_EQ(refusal("v 0 0\n"), "a.obj:1: `v` needs three finite numbers");
    EXPECT_EQ(refusal("v 0 0 nan\n"), "a.obj:1: `v` needs three finite numbers");
    EXPECT_EQ(refusal("\n\nvn 1 1e99 0\n"), "a.obj:3: `vn` needs three finite numbers");
    const std::string four = corners;
    EXPECT_EQ(refusal(four + "f 1 2\n"), "a.obj:5: a face of 2 corners; allowed are 3 and more");
    EXPECT_EQ(refusal(four + "f 1 2 3\nf 1 2 5\n"),
              "a.obj:6: vertex 5; up to this line there are 4");
    EXPECT_EQ(refusal(four + "f 1 2 -5\n"), "a.obj:5: vertex -5; up to this line there are 4");
    EXPECT_EQ(refusal(four + "f 1 2 three\n"), "a.obj:5: vertex 0; up to this line there are 4");
    EXPECT_EQ(refusal(four + "f 1//1 2//1 3//1\n"),
              "a.obj:5: normal 1; up to this line there are 0");
}

TEST(Mesh, RefusesAFileWithoutFaces)
{
    EXPECT_EQ(refusal(""), "a.obj: there is no face with an area in it");
    EXPECT_EQ(refusal(std::string(corners) + "f 1 1 1\n"),
              "a.obj: there is no face with an area in it");
    EXPECT_THROW(read_mesh("/nowhere/a.obj"), UsageError);
    EXPECT_THROW(read_mesh("/"), UsageError);
}

}  // namespace
}  // namespace gonio

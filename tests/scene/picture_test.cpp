// SPDX-License-Identifier: Apache-2.0
// A scene's [picture]: what is read, and what is refused at which place.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "gonio/scene.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::refusal;

const std::string material = "[[material]]\nname = \"grey\"\nmodel = \"lambert\"\n";
const std::string camera = "camera = { from = [0, 0, 1], to = [0, 0, 0] }\n";
const std::string mesh = "mesh = [{ file = \"a.obj\", material = \"grey\" }]\n";

TEST(SceneOfAPicture, IsRead)
{
    const Scene scene = load_scene(SCENES "/face_skin.toml");
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_TRUE(scene.tables.empty());
    const PictureRequest& picture = scene.picture.value();
    EXPECT_EQ(picture.width, 1024u);
    EXPECT_EQ(picture.meshes[0].file, SCENES "/mesh/head.obj");
    EXPECT_EQ(picture.meshes[1].material, 1u);
    EXPECT_NEAR(glm::length(std::get<DirectionalLight>(picture.lights[0]).towards), 1, 1e-15);
    EXPECT_EQ(std::get<PointLight>(picture.lights[1]).intensity.y, 0.66);
    EXPECT_EQ(std::get<UniformLight>(picture.lights[2]).radiance.z, 0.12);
    EXPECT_EQ(scene.materials[0].surface.value().model->id, "torrance_sparrow");
}

TEST(SceneOfAPicture, IsCheckedBefore)
{
    const std::string head = material + "[picture]\n";
    EXPECT_EQ(refusal(material + "@[picture]\n").substr(0, 9), "`picture`");
    EXPECT_EQ(refusal(head + mesh + "camera = @{ from = [0, 1, 0], to = [0, 0, 0] }\n"),
              "the camera looks along `up`, or nowhere");
    EXPECT_EQ(refusal(head + mesh + "camera = { from = @[0, 1], to = [0, 0, 0] }\n"),
              "`from` has 2 numbers; allowed are three: x, y, z");
    EXPECT_EQ(refusal(head + camera + mesh + "width = @0\n"),
              "`width` is 0; allowed is a whole number from 1 to 16384");
    EXPECT_EQ(refusal(head + camera + mesh + "background = [0, @-1, 0]\n"),
              "`background[1]` is -1; allowed is 0 to 1000000000000");
    EXPECT_EQ(refusal(head + camera + mesh +
                      "light = [{ kind = \"directional\", towards = @[0, 0, 0], irradiance = 1 "
                      "}]\n"),
              "`towards` is no direction");
    EXPECT_EQ(refusal("[[material]]\nname = \"grey\"\nskin = \"pyxopto\"\nsurface = { model = "
                      "\"ggx\", parameters = { alpha = @{ values = [0.1, 0.2] } } }\n[picture]\n" +
                      camera + mesh),
              "the surface of layers has no sweeps");
}

}  // namespace
}  // namespace gonio

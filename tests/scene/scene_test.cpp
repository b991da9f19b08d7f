// SPDX-License-Identifier: Apache-2.0
// Scene files that are right.
#include "gonio/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "gonio/job.hpp"
#include "gonio/model.hpp"

namespace gonio {
namespace {

TEST(ExampleScenes, AreRightAndCanBePlanned)
{
    for (const auto name : {"quickstart", "brushed_steel", "merl", "dfg", "slab"}) {
        const auto scene =
            load_scene(std::filesystem::path(SCENES) / (std::string(name) + ".toml"));
        EXPECT_THAT(scene.warnings, testing::IsEmpty());
        EXPECT_FALSE(plan_jobs(scene).empty());
    }
}

TEST(ExampleScenes, QuickstartHasEveryModel)
{
    std::set<std::string_view> ids;
    const auto scene = load_scene(std::filesystem::path(SCENES) / "quickstart.toml");
    for (const SceneMaterial& material : scene.materials)
        for (const Lobe& lobe : std::get<std::vector<Lobe>>(material.made_of))
            ids.insert(lobe.model->id);
    for (const Model& model : models()) EXPECT_TRUE(ids.contains(model.id)) << model.id;
}

TEST(Scene, HoldsWhatTheFileSays)
{
    const auto scene = parse_scene(R"(
[output]
directory = "here"
format = "npy"

[[material]]
name = "paint"
lobes = [
    { model = "lambert", weight = 0.5 },
    { model = "ggx", parameters = { alpha = 0.3, fresnel = "dielectric", eta = [1.4, 1.5, 1.6] } },
]

[[material]]
name = "brushed"
model = "ward"
parameters = { alpha_x = { values = [0.5, 0.1], as = "files" } }

[[table]]
name = "table"
material = "paint"
quantity = "brdf_cosine"
format = "exr"
precision = "half"
compression = "piz"
[table.grid]
kind = "rusinkiewicz"
theta_h = 2
theta_d = 3
phi_d = 4
samples = "node"
spacing = "merl"
)",
                                   "scene.toml");
    EXPECT_EQ(scene.directory, "here");
    ASSERT_EQ(scene.materials.size(), 2U);
    const auto& lobes = std::get<std::vector<Lobe>>(scene.materials[0].made_of);
    ASSERT_EQ(lobes.size(), 2U);
    EXPECT_EQ(lobes[0].weight, std::vector{0.5});
    EXPECT_EQ(lobes[1].model->id, "torrance_sparrow");
    EXPECT_EQ(lobes[1].values[lobes[1].model->index_of("alpha_y")], std::vector{0.3});
    EXPECT_EQ(lobes[1].values[lobes[1].model->index_of("eta")], (std::vector{1.4, 1.5, 1.6}));
    const auto& sweeps = scene.materials[1].sweeps;
    ASSERT_EQ(sweeps.size(), 1U);
    EXPECT_EQ(sweeps[0].parameter, "alpha_x");
    EXPECT_EQ(sweeps[0].values, (std::vector{0.5, 0.1}));
    EXPECT_FALSE(sweeps[0].axis);
    ASSERT_EQ(scene.tables.size(), 1U);
    const TableRequest& table = scene.tables[0];
    EXPECT_EQ(table.name, "table");
    EXPECT_EQ(table.material, 0U);
    EXPECT_EQ(table.quantity->id, "brdf_cosine");
    EXPECT_EQ(table.solver, "closed_form");
    EXPECT_EQ(table.storage.format, "exr");
    EXPECT_TRUE(table.storage.write.half);
    EXPECT_EQ(table.storage.write.compression, "piz");
    EXPECT_EQ(table.grid->kind, GridKind::rusinkiewicz);
    EXPECT_EQ(table.grid->axes[0].values, (std::vector{0.0, 90.0}));
    EXPECT_EQ(table.grid->axes[2].values.size(), 4U);
    EXPECT_THAT(scene.warnings,
                testing::ElementsAre("scene.toml:13:1: nothing is asked of material `brushed`"));
}

// Phong, CACM 18(6), 1975: ambient, diffuse and specular components.
TEST(Scene, HasTheComponentsOfPhongsShading)
{
    const auto scene = parse_scene(R"(
[[material]]
name = "clay"
ambient = [0.1, 0.05, 0.02]
diffuse = { model = "lambert", parameters = { rho = [0.8, 0.5, 0.3] } }
specular = { model = "phong", weight = 0.2, parameters = { exponent = { values = [5, 50] } } }

[[table]]
material = "clay"
quantity = "brdf"
grid = { kind = "isotropic", theta_i = 2, theta_o = 2, delta_phi = 4 }
)",
                                   "clay.toml");
    const Job job = plan_jobs(scene).front();
    ASSERT_EQ(job.materials.size(), 2U);
    for (const Material& material : job.materials) {
        ASSERT_EQ(material.lobes.size(), 2U);
        EXPECT_EQ(material.lobes[0].model->id, "lambert");
        EXPECT_EQ(material.lobes[1].model->id, "phong");
        EXPECT_EQ(material.ambient, (std::vector{0.1, 0.05, 0.02}));
    }
    EXPECT_EQ(job.header.axes.front().name, "phong.exponent");
    const auto& told = job.header.attributes;
    EXPECT_EQ(std::ranges::count(told, "ambient", [](const auto& entry) { return entry.first; }),
              1);
}

}  // namespace
}  // namespace gonio

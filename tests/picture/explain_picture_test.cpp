// SPDX-License-Identifier: Apache-2.0
// What pictures leave out, and that their plans say so.
#include "picture/explain_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "opencl/state.hpp"
#include "picture/mesh_fixtures.hpp"

namespace gonio {
namespace {

using glm::dvec3;
using testing::ElementsAre;

/// How many programs a picture had to build.
std::size_t built(const PictureRequest& request, const std::vector<SceneMaterial>& materials)
{
    const Device fresh;
    make_picture(fresh, request, materials);
    return fresh.state().programs.size();
}

/// How many programs its plan tells of.
std::size_t planned(const PictureRequest& request, const std::vector<SceneMaterial>& materials)
{
    std::set<std::string> programs;
    for (const PictureStage& stage : explain(Device(), request, materials).stages)
        if (!stage.kernel.empty()) programs.insert(stage.kernel);
    return programs.size();
}

std::vector<std::string> left_out(const PictureRequest& request,
                                  const std::vector<SceneMaterial>& materials)
{
    std::vector<std::string> all;
    for (const LeftOut& left : explain(Device(), request, materials).left_out)
        all.push_back(left.what);
    return all;
}

class PlanOfAPicture : public testing::Test {
protected:
    PlanOfAPicture()
    {
        folder_.add("ball.obj", test::sphere_obj(12, 24));
        request_.width = request_.height = 8;
        request_.photons = 1000;
        request_.camera = {.from = {0, 0, 4}, .to = {0, 0, 0}};
        request_.meshes = {{.file = folder_.path() / "ball.obj", .where = {}}};
    }

    static SceneMaterial lobes(const char* name)
    {
        return {name, std::vector{default_lobe(name)}, {}, {}};
    }

    test::MeshFolder folder_;
    PictureRequest request_;
    const std::vector<SceneMaterial> materials_{
        lobes("lambert"),
        lobes("phong"),
        {"layers", LayeredMedium{.layers = {{.mua = 1, .mus = 10}}}, {}, {}}};
    const DirectionalLight sun_{{0, 0, 1}, dvec3(1)};
};

TEST_F(PlanOfAPicture, TellsOfAllProgramsThatAreBuilt)
{
    const std::vector<std::pair<std::vector<PictureLight>, std::size_t>> cases{
        {{}, 0},
        {{DirectionalLight{{0, 0, 1}, dvec3(0)}}, 0},
        {{sun_}, 1},
        {{UniformLight{dvec3(1)}}, 1},
        {{sun_, UniformLight{dvec3(1)}}, 2}};
    for (const auto& [lights, programs] : cases) {
        request_.lights = lights;
        EXPECT_EQ(built(request_, materials_), programs);
        EXPECT_EQ(planned(request_, materials_), programs);
    }
    request_.meshes.front().material = 2;  // photons, their spread, and no surface
    EXPECT_EQ(built(request_, materials_), 2u);
    EXPECT_EQ(planned(request_, materials_), 2u);
}

TEST_F(PlanOfAPicture, WhatNoRayMeetsAndNoLightReachesIsNotBuilt)
{
    PictureMesh hidden = request_.meshes.front(), behind = hidden;
    hidden.material = 1;
    hidden.scale = 0.5;
    behind.material = 2;
    behind.translate = {0, 20, 20};
    request_.meshes.insert(request_.meshes.end(), {hidden, behind});
    request_.lights = {sun_};
    EXPECT_EQ(built(request_, materials_), 1u);
    request_.lights = {DirectionalLight{{0, 0, -1}, dvec3(1)}};
    EXPECT_EQ(built(request_, materials_), 0u);
}

TEST_F(PlanOfAPicture, SaysWhatIsLeftOut)
{
    request_.lights = {sun_, UniformLight{dvec3(0)}};
    EXPECT_THAT(left_out(request_, materials_),
                ElementsAre("albedo of `lambert`", "material `phong`", "material `layers`",
                            "1 of 2 lights", "21 of 22 models"));
    request_.meshes.front().material = 2;
    EXPECT_THAT(left_out(request_, materials_),
                ElementsAre("surface of `layers`", "colours of `layers`", "material `lambert`",
                            "material `phong`", "1 of 2 lights", "22 of 22 models"));
    const auto stages = explain(Device(), request_, materials_).stages;
    const double all =
        std::accumulate(stages.begin(), stages.end(), 0.0,
                        [](double sum, const PictureStage& stage) { return sum + stage.share; });
    EXPECT_NEAR(all, 1, 1e-12);
}

}  // namespace
}  // namespace gonio

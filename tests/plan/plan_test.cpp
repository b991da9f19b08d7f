// SPDX-License-Identifier: Apache-2.0
// From scenes to jobs: sweeps, headers, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "gonio/job.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::SceneText;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Job> plan(const std::string& text)
{
    return plan_jobs(parse_scene(text, "scene.toml"));
}

std::string material(const std::string& model, const std::string& parameters)
{
    return "name = \"steel\"\nmodel = \"" + model + "\"\nparameters = { " + parameters + " }";
}

std::string refused_plan(const std::string& text)
{
    try {
        plan(text);
    } catch (const UsageError& fault) {
        return fault.what();
    }
    return {};
}

double parameter(const Material& made, std::string_view name, std::size_t lobe = 0)
{
    const Lobe& of = made.lobes[lobe];
    return of.values[of.model->index_of(name)].front();
}

const std::string grid_of_360 =
    "kind = \"anisotropic\", theta_i = 2, phi_i = 3, theta_o = 4, phi_o = 5";

TEST(Plan, InvertsAlbedosThatAHalfSpaceCanHave)
{
    const auto scene = [](const std::string& layer, const std::string& albedo) {
        return "[[material]]\nname = \"wax\"\nlayers = [ { mus = 1, mua = 1, n = 1.4" + layer +
               " } ]\n[[table]]\nmaterial = \"wax\"\nquantity = \"single_scattering_albedo\"\n"
               "axes = { albedo = { values = [" +
               albedo + "] } }\n";
    };
    EXPECT_EQ(plan(scene("", "0.03, 1")).size(), 1U);
    EXPECT_EQ(refused_plan(scene("", "0.02, 1")),
              "scene.toml:4:1: `albedo` is 0.02; allowed is 0.0277778, which the surface reflects "
              "alone, to 1");
    EXPECT_EQ(
        refused_plan(scene(", d = 1", "0.5")),
        "scene.toml:4:1: the quantity `single_scattering_albedo` is that of a half-space: one "
        "layer without `d`");
}

TEST(Plan, MakesAJobOfATable)
{
    const auto jobs = plan(SceneText{.output = "directory = \"out\"\nprecision = \"half\""}.text());
    ASSERT_EQ(jobs.size(), 1U);
    const Job& job = jobs.front();
    EXPECT_EQ(job.name, "steel-brdf");
    EXPECT_EQ(job.path, "out/steel-brdf.exr");
    EXPECT_EQ(job.where, "scene.toml:7:1: ");
    EXPECT_EQ(job.materials.size(), 1U);
    EXPECT_EQ(job.measure, Measure::brdf);
    EXPECT_TRUE(job.write.half);
    EXPECT_EQ(job.header.unit, "1/sr");
    EXPECT_EQ(job.header.cells(), 24U);
    EXPECT_EQ(job.header.sweep_axes, 0U);
    EXPECT_THAT(job.header.channels, ElementsAre("Y"));
}

TEST(Plan, TakesTheDirectoryThatOverrides)
{
    const auto scene = parse_scene(SceneText{}.text(), "scene.toml");
    EXPECT_EQ(plan_jobs(scene, "elsewhere").front().path, "elsewhere/steel-brdf.exr");
    EXPECT_EQ(plan_jobs(scene).front().path, "tables/steel-brdf.exr");
}

TEST(Plan, KnowsTheQuantity)
{
    auto text = SceneText{}.text();
    text.replace(text.find("\"brdf\""), 6, "\"brdf_cosine\"");
    const auto jobs = plan(text);
    EXPECT_EQ(jobs.front().measure, Measure::brdf_cosine);
    EXPECT_EQ(jobs.front().header.quantity, "brdf_cosine");
}

TEST(Plan, MakesAxesOfSweepsInTheOrderOfTheFile)
{
    const auto jobs = plan(
        SceneText{.material = material("ward",
                                       "rho_s = [1, 0.5, 0], alpha_y = { values = [0.1, 0.2] }, "
                                       "alpha_x = { from = 0.01, to = 1, count = 3, spacing "
                                       "= \"log\", as = \"axis\" }"),
                  .grid = grid_of_360}
            .text());
    ASSERT_EQ(jobs.size(), 1U);
    const auto& header = jobs.front().header;
    EXPECT_EQ(header.sweep_axes, 2U);
    ASSERT_EQ(header.axes.size(), 6U);
    EXPECT_EQ(header.axes[0].name, "alpha_y");
    EXPECT_EQ(header.axes[1].name, "alpha_x");
    EXPECT_EQ(header.axes[2].name, "theta_i");
    EXPECT_EQ(header.axes[0].samples, Samples::node);
    EXPECT_THAT(header.axes[1].values, ElementsAre(0.01, testing::DoubleNear(0.1, 1e-15), 1.0));
    EXPECT_EQ(header.find("alpha_x"), nullptr);
    const auto& materials = jobs.front().materials;
    ASSERT_EQ(materials.size(), 6U);
    for (std::size_t k = 0; k < materials.size(); ++k) {
        EXPECT_EQ(parameter(materials[k], "alpha_y"), header.axes[0].values[k / 3]);
        EXPECT_EQ(parameter(materials[k], "alpha_x"), header.axes[1].values[k % 3]);
        EXPECT_EQ(materials[k].channels(), 3U);
    }
}

TEST(Plan, MakesFilesOfSweeps)
{
    const auto jobs = plan(
        SceneText{.material = material("ggx",
                                       "f0 = { values = [0.04, 0.5], as = \"files\" }, alpha = "
                                       "{ from = 0.1, to = 0.3, count = 3, as = \"axis\" }")}
            .text());
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_EQ(jobs[0].path, "tables/steel-brdf-f0=0.04.exr");
    EXPECT_EQ(jobs[1].path, "tables/steel-brdf-f0=0.5.exr");
    for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_EQ(jobs[k].materials.size(), 3U);
        for (const Material& made : jobs[k].materials)
            EXPECT_EQ(parameter(made, "f0"), k == 0 ? 0.04 : 0.5);
        EXPECT_EQ(std::get<double>(*jobs[k].header.find("f0")), k == 0 ? 0.04 : 0.5);
        EXPECT_EQ(jobs[k].header.axes.front().name, "alpha");
        EXPECT_EQ(parameter(jobs[k].materials[2], "alpha_x"), 0.3);
        EXPECT_EQ(parameter(jobs[k].materials[2], "alpha_y"), 0.3);
    }
}

TEST(Plan, MakesFilesOfSweepsOfLayers)
{
    const auto scene = [](const std::string& mua) {
        return "[[material]]\nname = \"milk\"\nlayers = [ { mua = 1, mus = 10, d = 0.1 },\n{ mua "
               "= " +
               mua +
               ", g = { values = [0, 0.9], as = \"files\" } } ]\n"
               "[[table]]\nmaterial = \"milk\"\nquantity = \"light_budget\"\n";
    };
    const auto jobs = plan(scene("{ from = 1, to = 3, count = 3, as = \"files\" }"));
    ASSERT_EQ(jobs.size(), 6U);
    EXPECT_EQ(jobs[3].path, "tables/milk-light_budget-layer_2.g=0.9-layer_2.mua=1.exr");
    const auto& layers = jobs[5].layers->medium.layers;
    EXPECT_EQ(layers[0].mua, 1);
    EXPECT_EQ(layers[1].mua, 3);
    EXPECT_EQ(std::get<HenyeyGreenstein>(layers[1].phase).g, 0.9);
    EXPECT_EQ(refused_plan(scene("{ values = [1, -2], as = \"files\" }")),
              "scene.toml:4:9: layer 2: mua = -2 must be finite and at least 0 1/cm");
    EXPECT_EQ(refused_plan(scene("{ values = [1, 2] }")),
              "scene.toml:4:9: of layers every value of a sweep makes a file; write as = "
              "\"files\"");
}

TEST(Plan, NamesParametersByLobe)
{
    const auto jobs = plan(SceneText{
        .material = "name = \"steel\"\nlobes = [ { model = \"lambert\", weight = 0.5 },\n"
                    "{ model = \"oren_nayar\", parameters = { sigma = { values = [10, 20] } } },\n"
                    "{ model = \"phong\", parameters = { exponent = 3 } },\n"
                    "{ model = \"phong\", parameters = { exponent = { values = [1, 9] } } } ]"}
                               .text());
    const auto& header = jobs.front().header;
    EXPECT_EQ(header.axes[0].name, "oren_nayar.sigma");
    EXPECT_EQ(header.axes[0].unit, "deg");
    EXPECT_EQ(header.axes[1].name, "phong_2.exponent");
    EXPECT_EQ(std::get<double>(*header.find("lambert.weight")), 0.5);
    EXPECT_EQ(std::get<double>(*header.find("phong_1.exponent")), 3);
    EXPECT_EQ(header.find("phong_2.exponent"), nullptr);
    EXPECT_EQ(parameter(jobs.front().materials[1], "exponent", 3), 9);
}

TEST(Plan, PutsParametersAndConventionsIntoTheHeader)
{
    const auto jobs = plan(SceneText{
        .material = "name = \"steel\"\nlobes = [ { model = \"schlick\", parameters = { k_s = "
                    "[1, 0, 0.5] } }, { model = \"oren_nayar\" } ]",
        .grid = "kind = \"isotropic\", theta_i = 2, theta_o = 3, delta_phi = 4, samples = "
                "\"node\""}
                               .text());
    const auto& header = jobs.front().header;
    const auto text = [&](const char* name) { return std::get<std::string>(*header.find(name)); };
    EXPECT_THAT(text("program"), testing::StartsWith("gonio "));
    EXPECT_EQ(text("grid"), "isotropic");
    EXPECT_EQ(text("storage"), "exr, float, zip");
    EXPECT_EQ(text("solver"), "closed_form");
    EXPECT_EQ(text("schlick.model"), "schlick");
    EXPECT_EQ(text("oren_nayar.sigma.unit"), "deg");
    EXPECT_THAT(text("directions"), HasSubstr("delta_phi = 180 deg is the mirror direction"));
    EXPECT_EQ(std::get<std::vector<double>>(*header.find("schlick.k_s")),
              (std::vector{1.0, 0.0, 0.5}));
    EXPECT_THAT(text("conversion"), HasSubstr("divided by"));
    // theta_i = 90 in 1 x 3 x 4 cells, theta_o = 90 in 2 x 1 x 4, both in 4.
    EXPECT_EQ(std::get<double>(*header.find("horizon.cells")), 16);
}

TEST(Plan, RefusesAnAnisotropicMaterialOnAGridWithoutATangent)
{
    const auto ward = material("ward", "alpha_x = 0.1, alpha_y = 0.2");
    const auto message =
        "scene.toml:7:1: material `steel` is anisotropic, and this grid has no "
        "tangent to tell its directions apart; use kind = \"anisotropic\"";
    EXPECT_EQ(refused_plan(SceneText{.material = ward}.text()), message);
    EXPECT_EQ(refused_plan(SceneText{.material = ward,
                                     .grid = "kind = \"rusinkiewicz\", theta_h = 2, theta_d = 2, "
                                             "phi_d = 2"}
                               .text()),
              message);
    EXPECT_EQ(refused_plan(SceneText{.material = ward, .grid = grid_of_360}.text()), "");
    EXPECT_EQ(
        refused_plan(
            SceneText{.material = material("ward", "alpha_x = { values = [0.2, 0.3] }")}.text()),
        message)
        << "only the second value is anisotropic";
}

TEST(Plan, RefusesTwoFilesOfOneName)
{
    const auto text = SceneText{.material = material("ward",
                                                     "alpha = { values = [0.1], as = "
                                                     "\"files\" }")}
                          .text();
    EXPECT_THAT(
        refused_plan(text + "[[table]]\nname = \"steel-brdf-alpha=0.1\"\nmaterial = \"other\"\n"
                            "quantity = \"brdf\"\nformat = \"npy\"\ngrid = { kind = "
                            "\"isotropic\", theta_i = 2, theta_o = 3, delta_phi = 4 }\n"
                            "[[material]]\nname = \"other\"\nmodel = \"ward\"\n"),
        HasSubstr("two tables would be written to `tables/steel-brdf-alpha=0.1"));
}

TEST(Plan, RefusesMoreThanCanBeListed)
{
    const std::string many = "{ from = 0.1, to = 1, count = 300 }";
    const std::string files = "{ from = 0.1, to = 1, count = 20000, as = \"files\" }";
    EXPECT_EQ(
        refused_plan(
            SceneText{.material = material("ward", "alpha_x = " + many + ", alpha_y = " + many)}
                .text()),
        "scene.toml:7:1: with the sweeps of this table there are more than 65536 combinations "
        "in the scene");
    EXPECT_EQ(refused_plan(SceneText{.material = material("ward", "alpha = " + files)}.text()),
              "scene.toml:7:1: with this table there are more than 10000 files");
}

TEST(Plan, RefusesATableThatCannotBeAddressed)
{
    const auto text =
        SceneText{
            .material = material("ward", "alpha = { from = 0.1, to = 1, count = 60000 }"),
            .grid = "kind = \"isotropic\", theta_i = 30000, theta_o = 30000, delta_phi = 60000"}
            .text();
    EXPECT_EQ(
        refused_plan(text),
        "scene.toml:7:1: a table of 60000 x 30000 x 30000 x 60000 cells is larger than can be "
        "addressed");
}

}  // namespace
}  // namespace gonio

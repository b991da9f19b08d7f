// SPDX-License-Identifier: Apache-2.0
// Layers, and the tables that can be asked of them.
#include <gtest/gtest.h>

#include <numbers>

#include "gonio/scene.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::refusal;

const std::string forearm =
    "[[material]]\nname = \"forearm\"\n"
    "layers = [ { mua = 0.2, mus = 100, g = 0.9, n = 1.53, d = 0.02 },\n"
    "           { mua = 0.7, mus = 200, phase = \"rayleigh\", n = 1.4, d = inf } ]\n"
    "[[table]]\nmaterial = \"forearm\"\n";

TEST(SceneOfLayers, ReadsWhatTablesAskFor)
{
    const Scene scene = parse_scene(
        forearm +
            "quantity = \"reflectance_r_alpha\"\nlight = \"beam\"\ntheta_i = 90e-1\nseed = 7\n"
            "axes = { r = { to = 2, count = 200 }, alpha = { to = 90, count = 30 } }\n"
            "max_error = 1e-3\ntime = \"5 min\"\nphotons = 1e9\n",
        "scene.toml");
    const TableRequest& table = scene.tables.front();
    EXPECT_EQ(table.solver, "monte_carlo");
    EXPECT_DOUBLE_EQ(table.light.incidence * 180 / std::numbers::pi, 9);
    EXPECT_EQ(table.seed, 7U);
    EXPECT_EQ(table.axes[0].unit, "cm");
    EXPECT_EQ(table.budget.photons, 1'000'000'000U);
    EXPECT_EQ(
        parse_scene(forearm + "quantity = \"light_budget\"\nlight = \"diffuse\"\n", "scene.toml")
            .tables.front()
            .solver,
        "adding_doubling");
}

TEST(SceneOfLayers, RefusesWhatDoesNotFit)
{
    EXPECT_EQ(refusal(forearm + "quantity = @\"reflectance\"\n").substr(0, 37),
              "there is no quantity `reflectance`; d");
    EXPECT_EQ(refusal(forearm + "quantity = \"reflectance_r\"\naxes = @{ z = { to = 1, count = 5 } "
                                "}\n"),
              "the quantity `reflectance_r` needs axes = { r = { to = …, count = … } }");
    EXPECT_EQ(refusal(forearm + "quantity = \"absorption_z\"\naxes = @{ z = { from = 0.1, to = 1, "
                                "count = 5 } }\n"),
              "the bins of `z` must be even, from 0 on");
    EXPECT_EQ(refusal(forearm + "quantity = \"reflectance_alpha\"\naxes = @{ alpha = { to = 60, "
                                "count = 5 } }\n"),
              "the angles of `alpha` must end at 90 deg, not at 60");
    EXPECT_EQ(refusal(forearm + "quantity = \"light_budget\"\nlight = \"diffuse\"\ntheta_i = "
                                "@10\n"),
              "`theta_i` is for a beam, not for diffuse light");
    EXPECT_EQ(refusal(forearm + "quantity = \"light_budget\"\nradius = @1\n"),
              "`radius` is for light = \"gaussian\" and light = \"top_hat\"");
    EXPECT_EQ(refusal(forearm + "quantity = \"light_budget\"\nlight = \"top_hat\"\nradius = @-1\n")
                  .substr(0, 25),
              "`radius` is -1; allowed i");
    EXPECT_EQ(refusal(forearm + "quantity = \"mean_albedo\"\nlight = @\"beam\"\n"),
              "the quantity `mean_albedo` says itself how light comes in and has no `light`");
    EXPECT_EQ(refusal(forearm + "quantity = \"directional_albedo\"\naxes = @{ mu = { to = 1, count "
                                "= 3, samples = \"node\" } }\n"),
              "`mu` is 0; the cosine of an incident direction must be above 0 and at most 1");
    const std::string inverse = "quantity = \"single_scattering_albedo\"\naxes = ";
    EXPECT_EQ(
        refusal(forearm + inverse + "@{ mu = { to = 1, count = 3 } }\n"),
        "the quantity `single_scattering_albedo` needs axes = { albedo = { to = …, count = … } "
        "}");
    EXPECT_EQ(refusal(forearm + inverse + "@{ albedo = { values = [0.5, 1.2] } }\n"),
              "`albedo` is 1.2; allowed is 0 to 1");
    EXPECT_EQ(refusal(forearm + "quantity = \"brdf\"\ngrid = @{ kind = \"isotropic\", theta_i = 3, "
                                "theta_o = 3, delta_phi = 3, samples = \"node\" }\n"),
              "layers have their BRDF on a grid of kind = \"isotropic\" with samples = \"centre\"");
    EXPECT_EQ(refusal(forearm + "quantity = \"brdf\"\nsolver = \"monte_carlo\"\ngrid = @{ kind = "
                                "\"isotropic\", theta_i = 3, theta_o = 3, delta_phi = 3 }\n"),
              "bins over 360 deg of `delta_phi` must be even in number, or end at 180 deg");
    EXPECT_EQ(refusal(forearm + "quantity = \"mean_path\"\ntime = @5\n"),
              "the quantity `mean_path` has no `time`: its numbers are searched for, each until it "
              "is exact");
    EXPECT_EQ(refusal(forearm + "quantity = \"mean_path\"\nmax_error = @0.1\n"),
              "the quantity `mean_path` has no `max_error`: it is as exact as it can be, and its "
              "error is beside it");
    EXPECT_EQ(refusal(forearm + "quantity = \"light_budget\"\nphotons = @10\n"),
              "`photons` is for solver = \"monte_carlo\", not adding_doubling, which has no noise");
}

TEST(SceneOfLayers, IsCheckedBefore)
{
    const auto bad_layers = [](const std::string& lines) {
        return refusal("[[material]]\nname = \"forearm\"\n" + lines);
    };
    EXPECT_EQ(bad_layers("layers = @[]\n"), "a layered medium needs at least one layer");
    EXPECT_EQ(bad_layers("layers = @[ { mua = -1 } ]\n"),
              "layer 1: mua = -1 must be finite and at least 0 1/cm");
    EXPECT_EQ(bad_layers("layers = [ { @mue = 1 } ]\n"), "unknown key `mue`; did you mean `mua`?");
    EXPECT_EQ(bad_layers("layers = [ { mua = 1, phase = \"rayleigh\", @g = 0.9 } ]\n"),
              "unknown key `g`; did you mean `n`?");
    EXPECT_EQ(bad_layers("layers = [ { mua = 1 } ]\nbottom = @\"blak\"\n"),
              "`bottom` cannot be \"blak\"; did you mean `black`?");
    EXPECT_EQ(bad_layers("layers = [ { mua = 1, d = @nan } ]\n"),
              "`d` is nan; allowed is at least 0");
}

}  // namespace
}  // namespace gonio

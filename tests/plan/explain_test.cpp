// SPDX-License-Identifier: Apache-2.0
// What plans say, and that leaving out changes no bit.
#include "plan/explain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compute/symmetry.hpp"
#include "gonio/compute.hpp"

namespace gonio {
namespace {

JobPlan plan_of(const std::string& scene)
{
    return explain(Device(), plan_jobs(parse_scene(scene, "s.toml"), testing::TempDir()).at(0));
}

std::vector<std::string> left_out(const JobPlan& plan)
{
    std::vector<std::string> all;
    for (const LeftOut& left : plan.left_out) all.push_back(left.what);
    return all;
}

TEST(PlanInWords, SaysWhatAGridLeavesOut)
{
    const JobPlan plan = plan_of(
        "[[material]]\nname = \"a\"\n[[material.lobes]]\nmodel = "
        "\"blinn_phong\"\n[[material.lobes]]\n"
        "model = \"lambert\"\nweight = 0\n[[table]]\nmaterial = \"a\"\nquantity = \"brdf\"\n"
        "grid = { kind = \"isotropic\", theta_i = 4, theta_o = 4, delta_phi = 64 }\n");
    EXPECT_EQ(plan.solver, "closed_form");
    EXPECT_EQ(left_out(plan), (std::vector<std::string>{
                                  "21 of 22 models", "1 of 2 lobes", "weights", "half of delta_phi",
                                  "half of theta_i, theta_o", "tangent frames"}));
    EXPECT_EQ(plan.left_out[1].saving, 2);
    EXPECT_NE(std::ranges::find(plan.definitions, "MIRROR=1"), plan.definitions.end());
    EXPECT_FALSE(plan.finished);
}

TEST(PlanInWords, SaysWhatLayersLeaveOut)
{
    const std::string layers =
        "[[material]]\nname = \"a\"\nlayers = [{ mua = 1, mus = 10, g = 0.5, n = 1, d = 1 }]\n"
        "[[table]]\nmaterial = \"a\"\n";
    const JobPlan exact = plan_of(layers + "quantity = \"light_budget\"\n");
    EXPECT_EQ(exact.solver, "adding_doubling");
    EXPECT_EQ(left_out(exact), std::vector<std::string>{"photons"});
    const JobPlan traced =
        plan_of(layers + "quantity = \"reflectance_r\"\naxes = { r = { to = 1, count = 4 } }\n");
    EXPECT_EQ(traced.solver, "monte_carlo");
    EXPECT_EQ(left_out(traced), (std::vector<std::string>{"the tally of transmitted light",
                                                          "the tally of absorbed light"}));
}

TEST(PlanInWords, SaysWhichChannelsAndFactorsAreNotComputed)
{
    const std::string grid =
        "[[table]]\nmaterial = \"a\"\nquantity = \"brdf\"\n"
        "grid = { kind = \"isotropic\", theta_i = 4, theta_o = 4, delta_phi = 64 }\n";
    const JobPlan grey = plan_of(
        "[[material]]\nname = \"a\"\nlobes = [ { model = \"lambert\", parameters = { rho = "
        "[0.5, 0.5, 0.2] } }, { model = \"ggx\" } ]\n" +
        grid);
    EXPECT_EQ(left_out(grey),
              (std::vector<std::string>{"20 of 22 models", "weights", "Fresnel's reflectance",
                                        "1 of 3 channels", "channels of 1 of 2 lobes",
                                        "tangent frames"}));
    EXPECT_EQ(grey.left_out[3].saving, 1.5);
    EXPECT_EQ(grey.definitions.front(), "CHANNELS=2");
    const JobPlan dark = plan_of(
        "[[material]]\nname = \"a\"\nlobes = [ { model = \"lambert\" }, { model = "
        "\"cook_torrance\", parameters = { fresnel = \"dielectric\", eta = 1 } } ]\n" +
        grid);
    EXPECT_EQ(left_out(dark), (std::vector<std::string>{"21 of 22 models", "1 of 2 lobes",
                                                        "weights", "tangent frames"}));
    const JobPlan black = plan_of(
        "[[material]]\nname = \"a\"\nlobes = [ { model = \"ward\", weight = 0 }, { model = "
        "\"ggx\", "
        "parameters = { fresnel = \"dielectric\", eta = 1 } } ]\n" +
        grid);
    EXPECT_EQ(black.left_out[0].what, "21 of 22 models");
    EXPECT_EQ(black.left_out[1].what, "1 of 2 lobes");
}

TEST(PlanInWords, KnowsTheProgramsOfIntegrals)
{
    const auto integral = [](const std::string& quantity, const std::string& axes) {
        return plan_of(
            "[[material]]\nname = \"a\"\nlobes = [ { model = \"ggx\", parameters = { f0 "
            "= [0.5, 0.6, 0.7] } } ]\n[[table]]\nmaterial = \"a\"\nquantity = \"" +
            quantity + "\"\naxes = { " + axes + " }\n");
    };
    const std::string mu = "mu = { to = 1, count = 3 }";
    EXPECT_EQ(integral("directional_albedo", mu).definitions,
              (std::vector<std::string>{"CHANNELS=3", "ISOTROPIC=1"}));
    EXPECT_EQ(integral("dfg", mu).definitions.front(), "CHANNELS=2");
    EXPECT_EQ(integral("kulla_conty", "mu_i = { to = 1, count = 3 }, mu_o = { to = 1, count = 3 }")
                  .definitions.front(),
              "CHANNELS=1");
}

TEST(PlanInWords, SaysWhichLayersAreNotNeeded)
{
    const std::string layers =
        "[[material]]\nname = \"a\"\nlayers = [ { n = 1.4, d = 0.1 }, { mua = 20, mus = 20, n = "
        "1.4, d = 0.5 }, { mus = 100, n = 1.4, d = 1 }, { mua = 1, n = 1.5, d = 1 } ]\n"
        "[[table]]\nmaterial = \"a\"\nmax_error = 1e-3\n";
    const JobPlan plan = plan_of(layers + "quantity = \"mean_albedo\"\n");
    EXPECT_EQ(left_out(plan),
              (std::vector<std::string>{"1 of 4 layers", "2 of 3 layers", "photons"}));
    EXPECT_EQ(plan.left_out[1].saving, 3);
    // Photons that are not followed there are few, and no work to speak of is saved.
    const JobPlan photons = plan_of(layers +
                                    "quantity = \"reflectance_alpha\"\nsolver = \"monte_carlo\"\n"
                                    "axes = { alpha = { to = 90, count = 2 } }\n");
    EXPECT_EQ(photons.left_out[0].what, "1 of 4 layers");
    EXPECT_FALSE(photons.left_out[0].saving);
    EXPECT_EQ(photons.left_out[1].what, "2 of 3 layers");
    EXPECT_FALSE(photons.left_out[1].saving);
}

TEST(PlanInWords, SaysWhatSkinLeavesOut)
{
    const auto skin = [](const std::string& model, const std::string& table) {
        return plan_of("[[material]]\nname = \"a\"\nskin = \"" + model +
                       "\"\n[[table]]\nmaterial = \"a\"\n" + table);
    };
    const std::string by_distance =
        "quantity = \"reflectance_r\"\naxes = { wavelength = { from = 400, to = 700, count = 30 }, "
        "r = { to = 0.2, count = 4 } }\n";
    const JobPlan absorbing = skin("meglinski_2002", by_distance);
    EXPECT_EQ(absorbing.solver, "monte_carlo");
    EXPECT_EQ(absorbing.kernel, "photon/transport.cl");
    ASSERT_EQ(left_out(absorbing),
              std::vector<std::string>{"photons of their own for each wavelength"});
    EXPECT_EQ(absorbing.left_out[0].why, "on the paths of 1 absorption is exchanged");
    EXPECT_EQ(absorbing.left_out[0].saving, 30);
    const JobPlan scattering = skin("jacques_1998", by_distance);
    ASSERT_EQ(scattering.left_out.size(), 1U);
    EXPECT_GT(scattering.left_out[0].saving, 4);
    EXPECT_LT(scattering.left_out[0].saving, 8);

    const JobPlan colour = skin("pyxopto", "quantity = \"colour_rgb\"\n");
    EXPECT_EQ(colour.solver, "adding_doubling");
    EXPECT_EQ(left_out(colour), std::vector<std::string>{"photons"});
    const JobPlan profile = skin("pyxopto",
                                 "quantity = \"profile_rgb\"\n"
                                 "axes = { r = { to = 0.1, count = 9 } }\n");
    EXPECT_NE(std::ranges::find(profile.definitions, "SPECTRUM_ROWS=10"),
              profile.definitions.end());
    EXPECT_GT(profile.tally_bytes, 9 * 4 * sizeof(std::uint64_t));  // bases of four and more

    const JobPlan fold = skin("pyxopto",
                              "quantity = \"transmittance_rgb\"\naxes = { d = { values = "
                              "[0.1, 0.2] } }\n");
    EXPECT_EQ(fold.solver, "adding_doubling");
    EXPECT_EQ(left_out(fold),
              (std::vector<std::string>{"photons", "layers that several sets or folds share"}));
}

/// Materials of one to three lobes, some of weight 0 or 1, which share their programs.
class Corpus {
public:
    explicit Corpus(std::size_t shape) : random_(shape), shape_(shape) {}

    Material material()
    {
        static constexpr std::array names = {"lambert", "ggx", "blinn_phong", "ward", "oren_nayar"};
        static constexpr std::array parameters = {"rho", "alpha", "exponent", "alpha", "sigma"};
        static constexpr std::array weights = {0.0, 1.0, 0.3};
        Material material{"corpus", {}};
        for (std::size_t k = 0; k <= shape_ % 3; ++k) {
            const std::size_t which = (shape_ + k * (1 + shape_ / 5)) % names.size();
            Lobe lobe = default_lobe(names[which]);
            lobe.set(parameters[which], std::vector{0.02 + 0.9 * uniform()});
            lobe.set("weight", std::vector{weights[(shape_ + k) % weights.size()]});
            material.lobes.push_back(lobe);
        }
        return material;
    }

    Grid grid()
    {
        const auto samples = uniform() < 0.5 ? Samples::centre : Samples::node;
        const std::size_t i = 2 + count(4), o = uniform() < 0.7 ? i : 2 + count(4);
        return isotropic_grid(i, o, 33 + count(40), samples, uniform() < 0.7 ? 360 : 180);
    }

private:
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    std::size_t count(int most) { return static_cast<std::size_t>(most * uniform()); }

    std::mt19937_64 random_;
    std::size_t shape_;
};

std::vector<float> values(const Device& device, const Material& material, const Grid& grid,
                          bool leave_out)
{
    std::vector<float> all;
    const auto sink = [&](const Rows<float>& rows) {
        all.insert(all.end(), rows.planes[0],
                   rows.planes[0] + rows.count * grid.axes.back().values.size());
    };
    compute_grid(device, material, Measure::brdf, grid, sink, {.leave_out = leave_out});
    return all;
}

TEST(PlanInWords, LeavingOutChangesNoBitOfTwoHundredTables)
{
    const Device device;
    std::size_t shorter = 0;
    for (std::size_t shape = 0; shape < 4; ++shape) {
        Corpus corpus(shape);
        for (int k = 0; k < 50; ++k) {
            const Material material = corpus.material();
            const Grid grid = corpus.grid();
            EXPECT_EQ(values(device, material, grid, true), values(device, material, grid, false))
                << "shape " << shape << ", table " << k;
            if (is_mirrored(material, grid) || is_reciprocal(material, Measure::brdf, grid))
                ++shorter;
        }
    }
    EXPECT_GT(shorter, 50U);
}

}  // namespace
}  // namespace gonio

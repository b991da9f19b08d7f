// SPDX-License-Identifier: Apache-2.0
// Photons on the device against the exact solution: where light ends, for every phase function,
// source and bottom, and at the extremes of each parameter.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gonio/errors.hpp"
#include "photon/photon_fixtures.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

TEST(PhotonBudgets, AreThoseOfTissue)
{
    ZTest test;
    compare_with_exact(test, "van de Hulst", van_de_hulst_slab(), 2'000'000);
    compare_with_exact(test, "van de Hulst, n = 1.5", van_de_hulst_slab(1.5), 1'000'000);
    compare_with_exact(test, "Giovanelli", giovanelli_half_space(), 500'000);
    compare_with_exact(test, "MCML sample", mcml_sample(), 500'000);
    compare_with_exact(test, "seven-layer skin", seven_layer_skin(), 100'000);
    test.expect_only_noise();
}

/// The digits of adding-doubling in double with 96 nodes, for the slab of van de Hulst 1980, table
/// 35 (0.09739, 0.66096), and Giovanelli 1955 (0.2600).
TEST(PhotonBudgets, AreThosePublished)
{
    ZTest test;
    const auto add = [&](const LayeredMedium& medium, std::uint64_t photons, double reflected,
                         double transmitted) {
        const auto result = simulate_photons(medium, photon_request(photons), photons);
        test.add("reflected", estimate(result.diffuse_reflectance), reflected, photons);
        // Scattered and unscattered light vary together: the error of a sum is below their sum.
        const double sum =
            result.diffuse_transmittance.mean + result.unscattered_transmittance.mean;
        EXPECT_NEAR(
            sum, transmitted,
            5 * (result.diffuse_transmittance.error + result.unscattered_transmittance.error));
    };
    add(van_de_hulst_slab(), 1'000'000, .09739464, .66095770);
    add(giovanelli_half_space(), 200'000, .21991857, 0);
    test.expect_only_noise();
}

/// With a gap between its peaks, of very different heights and widths.
TabulatedPhase forward_and_backward()
{
    return {{-1, -0.9, -0.4, 0.2, 0.95, 0.999, 1}, {3, 0.5, 0, 0, 2, 40, 900}};
}

TEST(PhotonBudgets, KnowEveryPhaseFunction)
{
    const std::vector<PhaseFunction> phases = {Isotropic{},
                                               Rayleigh{},
                                               TwoTermHenyeyGreenstein{0.9, -0.5, 0.7},
                                               HenyeyGreenstein{-0.6},
                                               HenyeyGreenstein{1e-6},
                                               forward_and_backward()};
    ZTest test;
    for (const PhaseFunction& phase : phases) {
        // The others below it, so that the program is the same for all.
        LayeredMedium medium = in_air({layer(1.4, 1, 9, 0, 0.2), layer(1.4, 1, 9, 0, 0.1),
                                       layer(1.4, 1, 9, 0, 0.1), layer(1.4, 1, 9, 0, 0.1)});
        medium.layers[0].phase = phase;
        medium.layers[1].phase = Rayleigh{};
        medium.layers[2].phase = TwoTermHenyeyGreenstein{0.9, -0.5, 0.7};
        medium.layers[3].phase = TabulatedPhase{{-1, 0.3, 1}, {2, 1, 1}};
        compare_with_exact(test, "phase function " + std::to_string(phase.index()), medium,
                           200'000);
    }
    test.expect_only_noise();
}

TEST(PhotonBudgets, KnowEveryBottomAndSource)
{
    ZTest test;
    for (const Bottom bottom : {Bottom::open, Bottom::black, Bottom::mirror, Bottom::diffuse}) {
        const LayeredMedium medium = layers_over(bottom);
        const std::string name = "bottom " + std::to_string(int(bottom));
        compare_with_exact(test, name, medium, 100'000);
        compare_with_exact(test, name + ", oblique", medium, 100'000, {.incidence = radians(65)});
        if (bottom == Bottom::diffuse)
            compare_with_exact(test, name + ", diffuse", medium, 100'000, {.beam = Beam::diffuse});
    }
    test.expect_only_noise();
}

TEST(PhotonBudgets, CrossClearLayersAndIndexSteps)
{
    ZTest test;
    // Glass slides, one of them on top, where light is reflected that has met nothing.
    const LayeredMedium slides =
        in_air({layer(1.5, 0, 0, 0, 0.1), layer(1.33, 1, 50, 0.8, 0.1), layer(1.5, 0, 0, 0, 0.1)});
    compare_with_exact(test, "slides", slides, 200'000);
    compare_with_exact(test, "slides, oblique", slides, 200'000, {.incidence = radians(50)});
    compare_with_exact(test, "slides, diffuse", slides, 200'000, {.beam = Beam::diffuse});
    // A dense clear layer, and a vacuum, where light beyond critical angles turns back.
    LayeredMedium steps = in_air(
        {layer(1.5, 0.5, 20, 0.5, 0.1), layer(1, 0, 0, 0, 0.1), layer(2.5, 0.2, 10, 0, 0.1)});
    compare_with_exact(test, "steps", steps, 200'000);
    compare_with_exact(test, "steps, grazing", steps, 200'000, {.incidence = radians(89.99)});
    test.expect_only_noise();
}

TEST(PhotonBudgets, HoldAtExtremes)
{
    ZTest test;
    compare_with_exact(test, "forward", in_air({layer(1.4, 1, 200, 0.99, 0.1)}), 100'000);
    compare_with_exact(test, "backward", in_air({layer(1.4, 1, 200, -0.99, 0.1)}), 100'000);
    compare_with_exact(test, "no scattering", in_air({layer(1.4, 3, 0, 0, 0.1)}), 200'000);
    compare_with_exact(test, "no absorption", in_air({layer(1.4, 0, 30, 0.5, 0.1)}), 200'000);
    compare_with_exact(test, "hardly any", in_air({layer(1.4, 1e-5, 100, 0.5, 0.1)}), 100'000);
    compare_with_exact(test, "thin", in_air({layer(1.4, 1e-3, 1e-3, 0.5, 1e-3)}), 1'000'000);
    compare_with_exact(test, "thin on thick",
                       in_air({layer(1.4, 0.1, 1, 0.5, 1e-6), layer(1.3, 1e4, 1e4, 0, 100)}),
                       200'000);
    std::vector<Layer> many;
    for (int k = 0; k < 20; ++k) many.push_back(layer(1.3 + 0.02 * (k % 3), 1, 30, 0.8, 0.01));
    compare_with_exact(test, "twenty layers", in_air(many), 100'000);
    test.expect_only_noise();
}

TEST(PhotonBudgets, SayWhatIsUnfinished)
{
    // Light that neither is absorbed nor finds its way out of 10^7 mean free paths.
    const LayeredMedium endless = in_air({layer(1, 0, 1e4, 0, 1e3)});
    const PhotonResult result = simulate_photons(endless, photon_request(64), 64);
    EXPECT_EQ(result.absorption[0].mean, 0);
    EXPECT_NEAR(result.diffuse_reflectance.mean + result.unfinished.mean, 1, 1e-12);
}

TEST(PhotonBudgets, RefuseWhatCannotBe)
{
    EXPECT_THROW(simulate_photons({}, photon_request(10), 10), UsageError);
    EXPECT_THROW(
        simulate_photons(mcml_sample(), photon_request(10, {.incidence = radians(90)}), 10),
        UsageError);
    PhotonRequest heavy = photon_request(10);
    heavy.roulette_below = 0.5;  // would carry more than the weight of a whole photon
    EXPECT_THROW(simulate_photons(mcml_sample(), heavy, 10), UsageError);
    PhotonRequest large = photon_request(10);
    large.tallies = {.absorbed = true, .depths = 1 << 20, .absorbed_radii = 1 << 20};
    EXPECT_THROW(simulate_photons(mcml_sample(), large, 10), UsageError);
}

}  // namespace
}  // namespace gonio::test

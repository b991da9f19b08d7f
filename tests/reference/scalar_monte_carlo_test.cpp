// SPDX-License-Identifier: Apache-2.0
// The scalar Monte Carlo against the exact solution: budgets, angles, every phase function,
// boundary and source.
#include "reference/scalar_monte_carlo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "gonio/errors.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/layered_media.hpp"
#include "reference/light_budgets.hpp"
#include "reference/z_test.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;

/// Simulates and solves the same, and adds all of the budget to the test.
void compare(ZTest& test, const std::string& name, const LayeredMedium& medium,
             const MonteCarloRequest& request, int nodes = 32)
{
    const LayeredSolution solution =
        solve_layers(medium, {.incidence = {request.incidence}}, nodes);
    ASSERT_LT(solution.error, 1e-3) << name;
    const LightBudget& exact = (request.diffuse ? solution.diffuse : solution.collimated[0]).budget;
    const MonteCarloResult result = simulate(medium, request);
    for_each_part(result, exact,
                  [&](const std::string& part, const Estimate& measured, double expected) {
                      test.add(name + ": " + part, measured, expected, request.photons);
                  });
    EXPECT_EQ(result.unfinished.mean, 0) << name;
}

/// Many batches, so that the spread of their means is known to 5 % and the deviations are close to
/// normal.
MonteCarloRequest photons(std::size_t count)
{
    return {.photons = count, .batches = 200};
}

TEST(ScalarMonteCarloTest, GivesTheExactBudgetsOfTissue)
{
    ZTest test;
    compare(test, "van de Hulst", van_de_hulst_slab(), photons(200'000));
    compare(test, "Giovanelli", giovanelli_half_space(), photons(40'000));
    compare(test, "MCML sample", mcml_sample(), photons(40'000));
    compare(test, "seven-layer skin", seven_layer_skin(), photons(4'000));
    compare(test, "five-layer skin", five_layer_skin(), photons(10'000));
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, DrawsInTheOrderOfMcmlIfAsked)
{
    const LayeredMedium medium{.layers = {layer(1, 0, 0, 0, 1), layer(1, 0, 0, 0, 1)}};
    const auto drawn = [&](bool at_all_boundaries) {
        std::size_t count = 0;
        simulate(medium, {.photons = 2,
                          .uniform =
                              [&] {
                                  ++count;
                                  return 0.5;
                              },
                          .batches = 2,
                          .draws_at_all_boundaries = at_all_boundaries});
        return count;
    };
    // Two photons meet two boundaries each, where nothing is left to chance.
    EXPECT_EQ(drawn(true), drawn(false) + 4);
    MonteCarloRequest request = photons(10'000);
    request.draws_at_all_boundaries = true;
    ZTest test;
    compare(test, "five-layer skin", five_layer_skin(), request);
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, LosesNoLight)
{
    LayeredMedium medium = mcml_sample();
    medium.bottom = Bottom::diffuse;
    medium.bottom_albedo = 0.3;
    for (const bool diffuse : {false, true}) {
        MonteCarloRequest request = photons(5'000);
        request.diffuse = diffuse;
        const MonteCarloResult result = simulate(medium, request);
        double sum = result.specular.mean + result.diffuse_reflectance.mean +
                     result.unscattered_transmittance.mean + result.diffuse_transmittance.mean +
                     result.bottom_absorption.mean + result.unfinished.mean;
        for (const Estimate& layer : result.absorption) sum += layer.mean;
        EXPECT_NEAR(sum, 1 + result.roulette.mean, 1e-12);
        EXPECT_NE(result.roulette.mean, 0);
    }
}

TEST(ScalarMonteCarloTest, TalliesWhatTheBudgetHolds)
{
    const MonteCarloResult result = simulate(mcml_sample(), photons(5'000));
    const auto sum = [](const std::vector<Estimate>& tally) {
        double all = 0;
        for (const Estimate& bin : tally) all += bin.mean;
        return all;
    };
    const double absorbed = sum(result.absorption);
    EXPECT_NEAR(sum(result.absorbed_z), absorbed, 1e-12);
    EXPECT_NEAR(sum(result.absorbed_zr), absorbed, 1e-12);
    EXPECT_NEAR(sum(result.transmitted_r), result.diffuse_transmittance.mean, 1e-12);
    EXPECT_NEAR(sum(result.transmitted_alpha), result.diffuse_transmittance.mean, 1e-12);
    EXPECT_NEAR(sum(result.reflected_r), sum(result.reflected_alpha), 1e-12);
    // The rest is reflected without scattering by the bottom, 4 mm down: 1e-8.
    EXPECT_NEAR(sum(result.reflected_r), result.diffuse_reflectance.mean, 1e-6);
}

TEST(ScalarMonteCarloTest, LeavesAtTheExactAngles)
{
    const LayeredMedium medium = van_de_hulst_slab(1.3);
    MonteCarloRequest request = photons(200'000);
    request.alpha_bins = 18;
    const MonteCarloResult result = simulate(medium, request);
    const AngularBins exact = exact_angular_bins(medium, request.alpha_bins);
    ZTest test;
    for (std::size_t i = 0; i < request.alpha_bins; ++i) {
        test.add("reflected, bin " + std::to_string(i), result.reflected_alpha[i],
                 exact.reflected[i], request.photons);
        test.add("transmitted, bin " + std::to_string(i), result.transmitted_alpha[i],
                 exact.transmitted[i], request.photons);
    }
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, AbsorbsByBeersLawWithoutScattering)
{
    const MonteCarloRequest request{
        .photons = 400'000, .incidence = radians(30), .batches = 200, .dz = 0.02};
    const MonteCarloResult result = simulate(in_air({layer(1.4, 5, 0, 0, infinite)}), request);
    const double sine = 0.5 / 1.4, attenuation = 5 / std::sqrt(1 - sine * sine);
    const double entered = 1 - result.specular.mean;
    ZTest test;
    for (std::size_t i = 0; i < request.z_bins; ++i) {
        const double z = double(i) * request.dz;
        test.add("depth " + std::to_string(z), result.absorbed_z[i],
                 entered * std::exp(-attenuation * z) * -std::expm1(-attenuation * request.dz),
                 request.photons);
    }
    test.expect_only_noise();
    // All of it lies on the refracted ray.
    const double slope = sine / std::sqrt(1 - sine * sine);
    const std::size_t bins = request.r_bins + 1;
    for (std::size_t z = 0; z < request.z_bins; ++z) {
        for (std::size_t r = 0; r < request.r_bins; ++r) {
            const double low = double(z) * request.dz * slope, high = low + request.dz * slope;
            const double r_low = double(r) * request.dr, r_high = r_low + request.dr;
            if (r_high < low || r_low > high) {
                EXPECT_EQ(result.absorbed_zr[z * bins + r].mean, 0);
            }
        }
    }
}

TEST(ScalarMonteCarloTest, KnowsEveryPhaseFunction)
{
    TabulatedPhase table{{-1, -0.2, 0.6, 1}, {0.5, 0, 1, 4}};
    const std::vector<PhaseFunction> phases = {Isotropic{}, Rayleigh{},
                                               TwoTermHenyeyGreenstein{0.9, -0.5, 0.7},
                                               HenyeyGreenstein{-0.6}, table};
    ZTest test;
    for (const PhaseFunction& phase : phases) {
        LayeredMedium medium = in_air({layer(1.4, 1, 9, 0, 0.2)});
        medium.layers[0].phase = phase;
        compare(test, "phase function " + std::to_string(phase.index()), medium, photons(50'000));
    }
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, KnowsEveryBottomAndSource)
{
    ZTest test;
    for (const Bottom bottom : {Bottom::open, Bottom::black, Bottom::mirror, Bottom::diffuse}) {
        const LayeredMedium medium = layers_over(bottom);
        const std::string name = "bottom " + std::to_string(int(bottom));
        MonteCarloRequest request = photons(30'000);
        compare(test, name, medium, request);
        request.incidence = radians(65);
        compare(test, name + ", oblique", medium, request);
        request.diffuse = true;
        compare(test, name + ", diffuse", medium, request);
    }
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, CrossesClearLayersAndIndexSteps)
{
    const Layer turbid = layer(1.2, 0.5, 10, 0.5, 0.1), glass = layer(1.5, 0, 0, 0, 0.2);
    ZTest test;
    compare(test, "glass above", in_air({glass, turbid}), photons(40'000));
    compare(test, "glass below", in_air({turbid, glass}), photons(40'000));
    compare(test, "glass between", in_air({turbid, glass, turbid}), photons(40'000));
    compare(test, "steps",
            in_air({layer(1.5, 1, 1e3, 0.5, 0.01), layer(1, 1e-6, 1e-6, 0.5, 1),
                    layer(2.5, 0.5, 0.5, 0, 1), layer(1.5, 0.1, 1e-6, 0, 1)}),
            photons(20'000));
    LayeredMedium dense = in_air({turbid});
    dense.n_above = 1.6;
    MonteCarloRequest request = photons(40'000);
    request.incidence = radians(40);
    compare(test, "from glass", dense, request);
    request.incidence = std::asin(1.2 / 1.6) + 1e-9;
    compare(test, "beyond the critical angle", dense, request);
    request.incidence = radians(89.99);
    compare(test, "grazing", in_air({turbid}), request);
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, StandsExtremes)
{
    ZTest test;
    for (const double g : {0.99, -0.99, 1e-6, -1e-6}) {
        compare(test, "g = " + std::to_string(g), in_air({layer(1.4, 1, 9, g, 1)}), photons(40'000),
                64);
    }
    for (const double depth : {1e-6, 1e-3, 1.0, 1e6}) {
        compare(test, "optical depth " + std::to_string(depth),
                in_air({layer(1.4, 0.1, 0.9, 0.5, depth)}), photons(40'000));
    }
    compare(test, "no absorption", in_air({layer(1.4, 0, 10, 0.5, 1)}), photons(20'000));
    compare(test, "hardly any absorption", in_air({layer(1.4, 1e-6, 10 - 1e-6, 0.5, 1)}),
            photons(20'000));
    compare(test, "20 layers", in_air(std::vector<Layer>(20, layer(1.4, 0.5, 10, 0.8, 0.01))),
            photons(10'000));
    test.expect_only_noise();
}

TEST(ScalarMonteCarloTest, ReportsPhotonsThatAreStopped)
{
    MonteCarloRequest request = photons(2'000);
    request.most_steps = 100;
    const MonteCarloResult result = simulate(in_air({layer(1, 0, 100, 0, 10)}), request);
    EXPECT_GT(result.unfinished.mean, 0.01);
    EXPECT_NEAR(result.unfinished.mean + result.diffuse_reflectance.mean, 1, 1e-12);
}

TEST(ScalarMonteCarloTest, StatesItsStandardErrors)
{
    // 100 runs: their spread is known to 7 %, the mean of the stated errors far better.
    constexpr int runs = 100;
    double sum = 0, squares = 0, stated = 0;
    for (int seed = 1; seed <= runs; ++seed) {
        MonteCarloRequest request{.photons = 2'000, .seed = std::uint64_t(seed), .batches = 20};
        const Estimate estimate = simulate(van_de_hulst_slab(), request).diffuse_reflectance;
        sum += estimate.mean;
        squares += estimate.mean * estimate.mean;
        stated += estimate.error * estimate.error;
    }
    const double variance = (squares - sum * sum / runs) / (runs - 1);
    EXPECT_NEAR(variance / (stated / runs), 1, 0.42);  // 3 standard deviations
}

TEST(ScalarMonteCarloTest, DependsOnItsSeedAlone)
{
    const auto reflectance = [](std::uint64_t seed) {
        return simulate(mcml_sample(), {.photons = 1'000, .seed = seed}).diffuse_reflectance.mean;
    };
    EXPECT_EQ(reflectance(1), reflectance(1));
    EXPECT_NE(reflectance(1), reflectance(2));
}

TEST(ScalarMonteCarloTest, RefusesWhatCannotBe)
{
    EXPECT_THROW(simulate({}, {}), UsageError);
    EXPECT_THROW(simulate(mcml_sample(), {.incidence = radians(90)}), UsageError);
}

}  // namespace
}  // namespace gonio::reference

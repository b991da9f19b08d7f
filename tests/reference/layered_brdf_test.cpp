// SPDX-License-Identifier: Apache-2.0
// The BRDF of layered media against Chandrasekhar's, single scattering, reciprocity and the
// budgets.
#include "reference/layered_brdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "reference/adding_doubling.hpp"
#include "reference/chandrasekhar.hpp"
#include "reference/gauss_legendre.hpp"
#include "reference/layered_media.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;
using std::numbers::pi;

TEST(LayeredBrdfTest, IsChandrasekharsForIsotropicScattering)
{
    const std::vector<double> angles = {0, radians(25), radians(60), radians(80), radians(88)};
    for (const double albedo : {0.5, 0.9, 0.999, 1 - 1e-7}) {
        const LayeredBrdf brdf = layered_brdf(in_air({layer(1, 1 - albedo, albedo, 0, infinite)}),
                                              angles, angles, {0, 1, pi}, 40);
        EXPECT_LT(brdf.error, 1e-3);
        auto value = brdf.values.begin();
        for (const double theta_i : angles) {
            for (const double theta_o : angles) {
                for (int phi = 0; phi < 3; ++phi, ++value) {
                    EXPECT_NEAR(*value,
                                chandrasekhar_brdf(std::cos(theta_i), std::cos(theta_o), albedo),
                                brdf.error + 1e-9);
                }
            }
        }
    }
}

TEST(LayeredBrdfTest, ScattersOnceInThinMedia)
{
    // A faint slab of optical depth 1e-4: f = mus p(angle) d / (mu_i mu_o), p(angle) / 4 per sr.
    constexpr double depth = 1e-4;
    const auto density = [](const PhaseFunction& phase, double cosine) {
        if (const auto* hg = std::get_if<HenyeyGreenstein>(&phase)) {
            const double g = hg->g;
            return (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        }
        return 3 * (1 + cosine * cosine) / (16 * pi);
    };
    const std::vector<double> angles = {radians(20), radians(55)},
                              azimuths = {0, radians(40), radians(90), pi};
    for (const PhaseFunction& phase :
         {PhaseFunction(HenyeyGreenstein{0.5}), PhaseFunction(Rayleigh{})}) {
        LayeredMedium medium = in_air({layer(1, 0, 1, 0, depth)});
        medium.layers[0].phase = phase;
        const LayeredBrdf brdf = layered_brdf(medium, angles, angles, azimuths, 40);
        auto value = brdf.values.begin();
        for (const double theta_i : angles) {
            for (const double theta_o : angles) {
                for (const double phi : azimuths) {
                    const double mu_i = std::cos(theta_i), mu_o = std::cos(theta_o);
                    const double cosine =
                        std::sin(theta_i) * std::sin(theta_o) * std::cos(phi) - mu_i * mu_o;
                    const double once = density(phase, cosine) * depth / (mu_i * mu_o);
                    EXPECT_NEAR(*value++, once, once * 15 * depth);  // what scatters again
                }
            }
        }
    }
}

TEST(LayeredBrdfTest, IsReciprocal)
{
    const std::vector<double> angles = {0, radians(30), radians(70)}, azimuths = {0, radians(100)};
    LayeredMedium medium = mcml_sample();
    medium.layers[0].n = 1.5;
    medium.layers[1].n = 1.3;
    const LayeredBrdf brdf = layered_brdf(medium, angles, angles, azimuths, 24);
    const auto at = [&](std::size_t i, std::size_t o, std::size_t p) {
        return brdf.values[(i * 3 + o) * 2 + p];
    };
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t o = 0; o < 3; ++o) {
            for (std::size_t p = 0; p < 2; ++p) EXPECT_NEAR(at(i, o, p), at(o, i, p), 1e-12);
        }
    }
    EXPECT_NEAR(at(0, 1, 0), at(0, 1, 1), 1e-12);  // normal incidence knows no azimuth
    EXPECT_GT(std::abs(at(1, 2, 0) - at(1, 2, 1)), 1e-3);
}

TEST(LayeredBrdfTest, AddsUpToTheBudget)
{
    // The hemisphere by Gauss-Legendre in the cosine and the trapezium rule in azimuth.
    constexpr int azimuths = 64;
    const QuadratureRule rule = gauss_legendre(24);
    std::vector<double> exit, azimuth;
    for (const double cosine : rule.nodes) exit.push_back(std::acos(cosine));
    for (int i = 0; i < azimuths; ++i) azimuth.push_back(2 * pi * i / azimuths);
    const LayeredMedium medium = in_air({layer(1.4, 1, 50, 0.7, infinite)});
    const LayeredBrdf brdf = layered_brdf(medium, {radians(50)}, exit, azimuth, 36);
    double albedo = 0;
    auto value = brdf.values.begin();
    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i) {
        for (int j = 0; j < azimuths; ++j)
            albedo += *value++ * rule.weights(i) * rule.nodes(i) * 2 * pi / azimuths;
    }
    const LayeredSolution solution = solve_layers(medium, {.incidence = {radians(50)}}, 36);
    EXPECT_NEAR(albedo, solution.collimated[0].budget.diffuse_reflectance, 1e-7);
}

TEST(LayeredBrdfTest, TellsItsPart)
{
    const LayeredMedium medium = in_air({layer(1.4, 1, 50, 0.8, 0.1), layer(1.4, 1, 50, 0.7, 1)});
    const std::vector<double> angles = {0, radians(50)}, azimuths = {0, pi};
    std::vector<double> parts;
    layered_brdf_to(medium, angles, angles, azimuths, 1e-4,
                    [&](double part) { parts.push_back(part); });
    ASSERT_GT(parts.size(), 1000U);
    // The last solution takes the longest, and each of its modes about as long.
    const double half = parts[parts.size() * 3 / 4];
    EXPECT_GT(half, 0.4);
    EXPECT_LT(half, 0.9);
    EXPECT_GT(parts.back(), 0.95);
    EXPECT_LE(std::ranges::max(parts), 1 + 1e-12);
    EXPECT_GE(std::ranges::min(parts), 0);
    int calls = 0;
    const auto stop = [&](double) {
        if (++calls == 3) throw std::runtime_error("interrupted");
    };
    EXPECT_THROW(layered_brdf_to(medium, angles, angles, azimuths, 1e-4, stop), std::runtime_error);
    EXPECT_LT(calls, 100);  // other processors end the doubling that they are at
}

}  // namespace
}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// One homogeneous layer: conservation, reciprocity, azimuth modes.
#include "reference/adding_doubling/slab.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/adding_doubling/redistribution.hpp"
#include "reference/layered_media.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;

const LocalDirections& directions()
{
    static const LocalDirections local = [] {
        ExactDirections exact;
        exact.add(1, {0, radians(45)});
        return LocalDirections(choose_directions(in_air({layer(1.4, 0, 1, 0, 1)}), 24, exact), 1.4);
    }();
    return local;
}

/// What of a unit of flux leaves on either side, for each direction of incidence.
Eigen::VectorXd leaving(const Slab& slab)
{
    const Eigen::VectorXd& worth = directions().root_weight;
    return worth_before(worth, slab.reflection + slab.transmission).cwiseQuotient(worth);
}

TEST(SlabTest, ConservesLightToTheLastDigits)
{
    for (const double g : {0.0, 0.9, -0.9, 0.99}) {
        for (const double depth : {1e-9, 1e-3, 1.0, 1e3}) {
            const Slab slab = solve_slab(layer(1.4, 0, 1, g, depth), directions(), 0);
            EXPECT_LT((leaving(slab).array() - 1).abs().maxCoeff(), 1e-11)
                << "g = " << g << ", depth " << depth;
        }
        // Absorption of 1e-9 along the way, to five digits of it.
        const Slab faint = solve_slab(layer(1.4, 1e-9, 1e-9, g, 1), directions(), 0);
        const Eigen::ArrayXd absorbed = 1 - leaving(faint).array(),
                             path = 1e-9 / directions().cosine;
        EXPECT_LT((absorbed / path - 1).abs().maxCoeff(), 1e-5);
    }
}

TEST(SlabTest, IsReciprocal)
{
    for (const int mode : {0, 1, 4}) {
        const Slab slab = solve_slab(layer(1.4, 0.3, 3, 0.7, 1), directions(), mode);
        for (const LightOperator& side : {slab.reflection, slab.transmission}) {
            EXPECT_LT((side.kernel - side.kernel.transpose()).cwiseAbs().maxCoeff(), 1e-13);
            EXPECT_GT(side.kernel.cwiseAbs().maxCoeff(), 1e-6);
        }
    }
}

TEST(SlabTest, SendsRetroReflectedLightToTheOppositeAzimuth)
{
    const Layer retro = layer(1.4, 0.1, 1, -0.9999, 1);  // far too sharp for 24 nodes
    const Slab mean = solve_slab(retro, directions(), 0),
               first = solve_slab(retro, directions(), 1);
    EXPECT_GT(mean.reflection.diagonal.minCoeff(), 0.4);
    EXPECT_EQ(first.reflection.diagonal, -mean.reflection.diagonal);
    EXPECT_EQ(first.transmission.diagonal, mean.transmission.diagonal);
}

TEST(SlabTest, ScattersOnlyInModesThatThePhaseFunctionHas)
{
    Layer rayleigh = layer(1.4, 0.1, 1, 0, 1);
    rayleigh.phase = Rayleigh{};
    EXPECT_GT(solve_slab(rayleigh, directions(), 2).reflection.kernel.maxCoeff(), 1e-3);
    EXPECT_TRUE(solve_slab(rayleigh, directions(), 3).reflection.kernel.isZero());
}

TEST(RedistributionTest, IsThePhaseFunctionAveragedOverAzimuth)
{
    const double g = 0.5;
    const Redistribution p = redistribute(layer(1.4, 0, 1, g, 1), directions(), 0);
    EXPECT_NEAR(p.scattering, 1, 1e-8);
    constexpr int azimuths = 200;
    for (Eigen::Index i = 0; i < directions().size(); i += 5) {
        for (Eigen::Index j = 0; j < directions().size(); j += 3) {
            const double a = directions().cosine(i), b = directions().cosine(j);
            double forward = 0, backward = 0;
            for (int k = 0; k < azimuths; ++k) {
                const double across = std::sqrt((1 - a * a) * (1 - b * b)) *
                                      std::cos(2 * std::numbers::pi * k / azimuths);
                const auto density = [&](double c) {
                    return (1 - g * g) / 2 / std::pow(1 + g * g - 2 * g * c, 1.5);
                };
                forward += density(across + a * b) / azimuths;
                backward += density(across - a * b) / azimuths;
            }
            EXPECT_NEAR(p.forward(i, j), forward, 1e-6);
            EXPECT_NEAR(p.backward(i, j), backward, 1e-6);
        }
    }
}

}  // namespace
}  // namespace gonio::reference

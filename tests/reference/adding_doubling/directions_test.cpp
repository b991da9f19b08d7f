// SPDX-License-Identifier: Apache-2.0
// Quadrature directions cover each medium's hemisphere, and no other.
#include "reference/adding_doubling/directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/layered_media.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;

TEST(DirectionsTest, IntegrateOverTheHemisphereOfEveryMedium)
{
    const Directions directions = choose_directions(seven_layer_skin(), 60, {});
    for (const double n : {1.0, 1.34, 1.39, 1.4, 1.44, 1.53}) {
        const LocalDirections local(directions, n);
        EXPECT_EQ(local.quadrature, local.size());
        EXPECT_GT(local.cosine.minCoeff(), 0);
        const Eigen::ArrayXd weight = local.root_weight.array().square() / (n * n);
        EXPECT_NEAR(weight.sum(), 1, 1e-13) << n;                        // 2 mu dmu
        EXPECT_NEAR((weight / local.cosine).sum(), 2, 1e-5) << n;        // 2 dmu
        EXPECT_NEAR((weight * local.cosine).sum(), 2.0 / 3, 1e-8) << n;  // 2 mu^2 dmu
    }
}

TEST(DirectionsTest, FollowSnellsLaw)
{
    const Direction direction{1.5, std::cos(radians(30))};
    EXPECT_NEAR(std::sqrt(direction.normal_squared(1.0)), std::sqrt(1 - 0.75 * 0.75), 1e-15);
    EXPECT_LT(Direction({1.5, std::cos(radians(42))}).normal_squared(1.0), 0);
    // A grazing direction keeps its digits: 1 - sin^2 would lose all of them.
    EXPECT_DOUBLE_EQ(Direction({1.4, 1e-9}).normal_squared(1.4), 1.4e-9 * 1.4e-9);
}

TEST(DirectionsTest, KeepExactOnesApart)
{
    ExactDirections exact;
    EXPECT_EQ(exact.add(1.5, {0, radians(60)}), Places({0, 1}));
    EXPECT_EQ(exact.add(1.5, {radians(60)}), Places({1}));  // each once
    const Directions directions = choose_directions(van_de_hulst_slab(1.5), 30, exact);
    ASSERT_EQ(directions.all.size(), std::size_t(directions.quadrature) + 2);
    const LocalDirections inside(directions, 1.5), outside(directions, 1);
    EXPECT_EQ(inside.size() - inside.quadrature, 2);
    EXPECT_EQ(outside.size() - outside.quadrature, 1);  // 60 degrees cannot leave
    EXPECT_LT(outside.quadrature, inside.quadrature);
}

TEST(DirectionsTest, AreFewerInEveryPartOfACoarserSet)
{
    // Parts are told by the medium that grazes there.
    const auto count = [](int nodes, double n) {
        const auto all = choose_directions(seven_layer_skin(), nodes, {}).all;
        return std::count_if(all.begin(), all.end(), [&](const Direction& d) { return d.n == n; });
    };
    for (const double n : {1.0, 1.34, 1.39, 1.4, 1.44, 1.53}) {
        for (const int nodes : {48, 96}) EXPECT_LT(count(coarser(nodes), n), count(nodes, n));
    }
}

}  // namespace
}  // namespace gonio::reference

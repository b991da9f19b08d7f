// SPDX-License-Identifier: Apache-2.0
// Smooth boundaries against the Fresnel equations as they are written elsewhere in gonio.
#include "reference/adding_doubling/interface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/fresnel.hpp"
#include "reference/layered_media.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;

/// Only directions at these angles in a medium of index n.
Directions exactly(double n, const std::vector<double>& angles)
{
    Directions directions;
    ExactDirections exact;
    exact.add(n, angles);
    directions.all = exact.all();
    directions.root_weight.setOnes(Eigen::Index(angles.size()));
    return directions;
}

TEST(InterfaceTest, IsFresnels)
{
    const std::vector<double> angles = {0,           radians(10), radians(41),
                                        radians(50), radians(85), radians(89.99)};
    for (const double n : {1.0, 1.33, 1.5, 2.5}) {
        for (const double behind : {1.0, 1.33, 1.5, 2.5}) {
            const Interface interface = fresnel_interface(exactly(n, angles), n, behind);
            const Interface reversed = fresnel_interface(exactly(n, angles), behind, n);
            for (std::size_t i = 0; i < angles.size(); ++i) {
                const auto at = static_cast<Eigen::Index>(i);
                EXPECT_NEAR(interface.reflected(at),
                            fresnel_exact(behind / n, 0, std::cos(angles[i])), 1e-12);
                EXPECT_DOUBLE_EQ(interface.reflected(at) + interface.transmitted(at), 1);
                EXPECT_NEAR(reversed.reflected(at), interface.reflected(at), 1e-15);
            }
        }
    }
}

TEST(InterfaceTest, FollowsUnscatteredLightThroughAStack)
{
    // Two clear plates: the transmittance of a pile of 4 surfaces is (1 - r) / (1 + 3 r), Stokes
    // 1862.
    const LayeredMedium plates =
        in_air({layer(1.5, 0, 0, 0, 1), layer(1, 0, 0, 0, 1), layer(1.5, 0, 0, 0, 1)});
    const Interface pile = follow_unscattered(plates, exactly(1, {0}));
    EXPECT_NEAR(pile.transmitted(0), 0.96 / 1.12, 1e-14);
    EXPECT_NEAR(pile.reflected(0), 0.16 / 1.12, 1e-14);

    const Interface slab = follow_unscattered(van_de_hulst_slab(), exactly(1, {0, radians(60)}));
    EXPECT_NEAR(slab.transmitted(0), std::exp(-2), 1e-15);
    EXPECT_NEAR(slab.transmitted(1), std::exp(-4), 1e-15);
    EXPECT_EQ(slab.reflected(0), 0);
}

TEST(InterfaceTest, CallsClearPlatesSpecular)
{
    const Directions normal = exactly(1, {0});
    const Layer glass = layer(1.5, 0, 0, 0, 1), tissue = layer(1.4, 1, 10, 0.8, 1);
    const double first = 0.04, second = std::pow(0.1 / 2.9, 2);
    EXPECT_NEAR(specular_reflectance(in_air({tissue, glass}), normal)(0), std::pow(0.4 / 2.4, 2),
                1e-15);
    // Wang and Jacques, MCML manual, eq. 3.21.
    EXPECT_NEAR(specular_reflectance(in_air({glass, tissue}), normal)(0),
                first + (1 - first) * (1 - first) * second / (1 - first * second), 1e-15);
}

}  // namespace
}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Sums and errors of weights, with as many photons as anybody will ever follow.
#include "photon/weight_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "photon/program.hpp"

namespace gonio::test {
namespace {

TEST(WeightSums, HoldATrillionPhotons)
{
    // 10^12 photons weigh 2^70: more than 64 bits hold, and one unit more is not lost.
    constexpr std::uint64_t batch = 1'000'000'000;
    WeightSums sums(3);
    for (int k = 0; k < 1000; ++k)
        sums.add_batch({batch * whole_photon, batch * (whole_photon / 4), k == 0 ? 1U : 0U}, batch);
    EXPECT_EQ(sums.photons(), 1'000'000'000'000U);
    EXPECT_EQ(sums.fraction(0).mean, 1);
    EXPECT_EQ(sums.fraction(0).error, 0);
    EXPECT_EQ(sums.fraction(1).mean, 0.25);
    EXPECT_DOUBLE_EQ(sums.fraction(2).mean, 1e-12 / whole_photon);
}

TEST(WeightSums, KnowTheErrorOfTheMean)
{
    // Batches of unequal size: the mean of 1 and 3 over 10 photons each, and 2 over 5.
    WeightSums sums(1);
    sums.add_batch({std::uint64_t{1} * 10 * whole_photon}, 10);
    EXPECT_TRUE(std::isinf(sums.fraction(0).error));
    sums.add_batch({std::uint64_t{3} * 10 * whole_photon}, 10);
    sums.add_batch({std::uint64_t{2} * 5 * whole_photon}, 5);
    EXPECT_DOUBLE_EQ(sums.fraction(0).mean, 2);
    // sum of m (mean_b - mean)^2 = 20, over 2 degrees of freedom and 25 photons
    EXPECT_DOUBLE_EQ(sums.fraction(0).error, std::sqrt(20.0 / 2 / 25));
}

}  // namespace
}  // namespace gonio::test

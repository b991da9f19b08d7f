// SPDX-License-Identifier: Apache-2.0
// The two things that are made of a phase function, its moments and its random angles, say the
// same.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/cosine_sampler.hpp"
#include "reference/phase_moments.hpp"

namespace gonio::reference {
namespace {

/// Henyey and Greenstein 1941 at points that are dense in the forward peak.
TabulatedPhase tabulated_henyey_greenstein(double g)
{
    TabulatedPhase table;
    constexpr int count = 4000;
    for (int i = 0; i <= count; ++i) {
        const double distance = 2 * std::pow(1 - double(i) / count, 3);
        table.cosine.push_back(1 - distance);
        table.value.push_back(std::pow((1 - g) * (1 - g) + 2 * g * distance, -1.5));
    }
    return table;
}

/// Moments of the angles that evenly spread random numbers give.
Eigen::VectorXd sampled_moments(const PhaseFunction& phase, int count)
{
    constexpr int numbers = 400'000;
    const CosineSampler sample(phase);
    Eigen::VectorXd moments = Eigen::VectorXd::Zero(count);
    for (int i = 0; i < numbers; ++i) {
        const double x = sample((i + 0.5) / numbers);
        double before = 0, p = 1;
        for (int l = 0; l < count; ++l) {
            moments(l) += p / numbers;
            const double after = ((2 * l + 1) * x * p - l * before) / (l + 1);
            before = p;
            p = after;
        }
    }
    return moments;
}

TEST(PhaseFunctionsTest, SampleTheirMoments)
{
    const std::vector<PhaseFunction> phases = {
        HenyeyGreenstein{0},
        HenyeyGreenstein{0.9},
        HenyeyGreenstein{-0.7},
        HenyeyGreenstein{1e-6},
        Isotropic{},
        Rayleigh{},
        TwoTermHenyeyGreenstein{0.9, -0.3, 0.8},
        tabulated_henyey_greenstein(0.8),
        TabulatedPhase{{-1, -0.5, 0.2, 1}, {0, 2, 0, 5}},
        TabulatedPhase{{-1, 0, 0.5, 1}, {1, 0, 0, 1}},
    };
    for (const PhaseFunction& phase : phases) {
        const Eigen::VectorXd expected = legendre_moments(phase, 12),
                              sampled = sampled_moments(phase, 12);
        EXPECT_EQ(expected(0), 1);
        for (int l = 0; l < 12; ++l) {
            EXPECT_NEAR(sampled(l), expected(l), 1e-6) << "kind " << phase.index() << ", l = " << l;
        }
    }
}

TEST(PhaseFunctionsTest, KeepTheWholeRangeOfAngles)
{
    for (const PhaseFunction& phase :
         {PhaseFunction(HenyeyGreenstein{0.99}), PhaseFunction(HenyeyGreenstein{-0.99}),
          PhaseFunction(Isotropic{}), PhaseFunction(Rayleigh{}),
          PhaseFunction(TwoTermHenyeyGreenstein{0.5, -0.5, 0.5}),
          PhaseFunction(TabulatedPhase{{-1, 0.5, 1}, {1, 0, 3}})}) {
        const CosineSampler sample(phase);
        EXPECT_NEAR(sample(0x1p-54), -1, 1e-7);
        EXPECT_NEAR(sample(1 - 0x1p-53), 1, 1e-7);
        for (const double u : {0x1p-54, 0.25, 0.5, 1 - 0x1p-53}) EXPECT_LE(std::abs(sample(u)), 1);
    }
}

TEST(PhaseFunctionsTest, HaveTheirMomentsInClosedForm)
{
    const Eigen::VectorXd forward = legendre_moments(HenyeyGreenstein{0.9}, 40);
    const Eigen::VectorXd table = legendre_moments(tabulated_henyey_greenstein(0.9), 40);
    for (int l = 0; l < 40; ++l) {
        EXPECT_DOUBLE_EQ(forward(l), std::pow(0.9, l));
        EXPECT_NEAR(table(l), forward(l), 2e-6);
    }
    // A triangle: 1 + cos has the mean cosine 1/3 and nothing beyond.
    const Eigen::VectorXd triangle =
        legendre_moments(TabulatedPhase{{-1, 0.25, 1}, {0, 1.25, 2}}, 6);
    EXPECT_NEAR(triangle(1), 1.0 / 3, 1e-15);
    for (int l = 2; l < 6; ++l) EXPECT_NEAR(triangle(l), 0, 1e-15);
    EXPECT_DOUBLE_EQ(legendre_moments(Rayleigh{}, 3)(2), 0.1);
    EXPECT_EQ(legendre_moments(Rayleigh{}, 2).size(), 2);
}

}  // namespace
}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Gauss-Legendre rules are exact for the polynomials that they should be, and for no more.
#include "reference/gauss_legendre.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gonio::reference {
namespace {

double integral_of_power(const QuadratureRule& rule, int power)
{
    return rule.weights.dot(rule.nodes.array().pow(power).matrix());
}

TEST(GaussLegendreTest, IsExactUpToItsDegree)
{
    for (const int count : {1, 2, 3, 7, 24, 150}) {
        const QuadratureRule rule = gauss_legendre(count);
        ASSERT_EQ(rule.nodes.size(), count);
        EXPECT_GT(rule.nodes.minCoeff(), 0);
        EXPECT_LT(rule.nodes.maxCoeff(), 1);
        for (const int power : {0, 1, count, 2 * count - 1}) {
            EXPECT_NEAR(integral_of_power(rule, power), 1.0 / (power + 1), 1e-14)
                << count << " nodes";
        }
    }
    EXPECT_GT(std::abs(integral_of_power(gauss_legendre(3), 6) - 1.0 / 7), 1e-4);
}

}  // namespace
}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// The algebra of light operators, on small random ones.
#include "reference/adding_doubling/light_operator.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gonio::reference {
namespace {

constexpr Eigen::Index size = 7, quadrature = 5;

/// Numbers of no meaning, small enough for series to converge.
LightOperator some_operator(int seed)
{
    LightOperator a{Eigen::VectorXd(size), Eigen::MatrixXd(size, size), quadrature};
    for (Eigen::Index i = 0; i < size; ++i) {
        a.diagonal(i) = 0.3 * std::sin(double(seed + 3 * i));
        for (Eigen::Index j = 0; j < size; ++j)
            a.kernel(i, j) = 0.1 * std::cos(double(seed + 5 * i + 7 * j * j));
    }
    return a;
}

void expect_equal(const LightOperator& a, const LightOperator& b)
{
    EXPECT_LT((a.diagonal - b.diagonal).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((a.kernel - b.kernel).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(a.quadrature, b.quadrature);
}

TEST(LightOperatorTest, MultipliesAssociatively)
{
    const LightOperator a = some_operator(1), b = some_operator(2), c = some_operator(3);
    expect_equal((a * b) * c, a * (b * c));
    expect_equal(a * (b + c), a * b + a * c);
    expect_equal(a * specular(Eigen::VectorXd::Ones(size), quadrature), a);
    const Eigen::ArrayXd mirror = b.diagonal;
    expect_equal(mirror * a, specular(b.diagonal, quadrature) * a);
}

TEST(LightOperatorTest, SumsRoundTrips)
{
    const LightOperator a = some_operator(4), b = some_operator(5);
    LightOperator sum = b, term = b;
    for (int i = 0; i < 200; ++i) {
        term = a * term;
        sum = sum + term;
    }
    expect_equal(after_round_trips(a, b), sum);
}

TEST(LightOperatorTest, LeavesTrappedLightAlone)
{
    // Direction 2 is reflected without loss for ever, and nothing gets into it.
    Eigen::VectorXd kept = Eigen::VectorXd::Constant(size, 0.5),
                    entering = Eigen::VectorXd::Ones(size);
    kept(2) = 1;
    entering(2) = 0;
    const LightOperator result =
        after_round_trips(specular(kept, quadrature), specular(entering, quadrature));
    EXPECT_EQ(result.diagonal(2), 0);
    EXPECT_DOUBLE_EQ(result.diagonal(3), 2);
    EXPECT_TRUE(result.kernel.isZero());
}

TEST(LightOperatorTest, AddsUpFlux)
{
    const LightOperator a = some_operator(6), b = some_operator(7);
    const Eigen::VectorXd worth = some_operator(8).diagonal;
    const Eigen::VectorXd one = worth_before(worth, a * b),
                          two = worth_before(worth_before(worth, a), b);
    EXPECT_LT((one - two).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace gonio::reference

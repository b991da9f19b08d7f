// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectances that optics books and other systems print.
#include "reference/fresnel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/gauss_legendre.hpp"

namespace gonio::reference {
namespace {

using std::numbers::pi;

template <class Function>
double cosine_mean(Function f)
{
    const QuadratureRule rule = gauss_legendre(200);
    double sum = 0;
    for (int k = 0; k < 200; ++k) sum += 2 * rule.weights[k] * f(rule.nodes[k]) * rule.nodes[k];
    return sum;
}

TEST(FresnelTest, Glass)
{
    EXPECT_NEAR(fresnel_exact(1.5, 0, 1), 0.04, 1e-15);
    // the test suite of Mitsuba 3
    const double s = 0.3033370452, p = 0.0920133630;
    EXPECT_NEAR(fresnel_exact(1.5, 0, std::cos(pi / 4)), (s * s + p * p) / 2, 1e-10);
    const double brewster = std::atan(1.5), s_brewster = 0.38461509;
    EXPECT_NEAR(fresnel_exact(1.5, 0, std::cos(brewster)), s_brewster * s_brewster / 2, 2e-7);
    EXPECT_NEAR(fresnel_exact(1.5, 0, 1e-12), 1, 1e-10);
}

TEST(FresnelTest, TotalReflection)
{
    const double critical = std::sqrt(1 - 1 / 2.25);
    EXPECT_NEAR(fresnel_exact(1 / 1.5, 0, critical * 0.999), 1, 1e-14);
    EXPECT_LT(fresnel_exact(1 / 1.5, 0, critical * 1.001), 0.9);
}

// The cosine-weighted means of a program in Python; inside of glass 1 - (1 - F)/n^2 exactly.
TEST(FresnelTest, Means)
{
    const double indices[] = {1.1, 1.3, 1.33, 1.4, 1.5, 1.6, 1.8, 2, 2.5, 3};
    const double means[] = {0.025157, 0.061132, 0.065931, 0.076812, 0.091778,
                            0.106246, 0.134054, 0.160597, 0.221867, 0.276203};
    for (int k = 0; k < 10; ++k) {
        const double n = indices[k];
        const double outside = cosine_mean([n](double c) { return fresnel_exact(n, 0, c); });
        EXPECT_NEAR(outside, means[k], 6e-7) << n;
        // below the critical angle the mean inside is an integral over the transmitted cosine
        const double inside = cosine_mean([n](double c) {
            return fresnel_exact(1 / n, 0, std::sqrt(1 - (1 - c * c) / (n * n)));
        });
        EXPECT_NEAR(inside, outside, 1e-12) << n;
        EXPECT_NEAR(1 - 1 / (n * n) + inside / (n * n), 1 - (1 - outside) / (n * n), 1e-12);
    }
    EXPECT_NEAR(cosine_mean([](double c) { return fresnel_schlick(0.3, c); }), 0.3 + 0.7 / 21,
                1e-14);
}

// An index near 1, with e = n^2 - 1: s light e/(4 c^2), p light e (2 c^2 - 1)/(4 c^2). The textbook
// form cancels there.
TEST(FresnelTest, NearlyTheSameMedium)
{
    EXPECT_EQ(fresnel_exact(1, 0, 1e-7), 0);
    const double eta = 1 + 1e-9, e = (eta - 1) * (eta + 1), c = 0.5;
    const double s = e / (4 * c * c), p = s * (2 * c * c - 1);
    EXPECT_NEAR(fresnel_exact(eta, 0, c) / ((s * s + p * p) / 2), 1, 1e-7);
}

// Born & Wolf 14.2 at normal incidence: ((n - 1)^2 + k^2)/((n + 1)^2 + k^2).
TEST(FresnelTest, Metals)
{
    const double n = 0.2, k = 3.4;
    EXPECT_NEAR(fresnel_exact(n, k, 1), (0.64 + k * k) / (1.44 + k * k), 1e-14);
    EXPECT_NEAR(fresnel_exact(n, k, 1e-12), 1, 1e-10);
}

}  // namespace
}  // namespace gonio::reference

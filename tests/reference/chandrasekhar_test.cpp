// SPDX-License-Identifier: Apache-2.0
// Chandrasekhar's H function, BRDF and albedos against tables and against his equations.
#include "reference/chandrasekhar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "reference/csv.hpp"
#include "reference/gauss_legendre.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;

TEST(ChandrasekharTest, GivesEveryDigitOfTheTables)
{
    const auto h = read_csv("layers/chandrasekhar_h.csv");
    ASSERT_EQ(h.size(), 23u);
    for (const CsvRow& row : h) {
        for (const char* w : {"0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.85", "0.9",
                              "0.925", "0.95", "0.975", "0.99", "0.995", "0.999", "0.9999", "1"}) {
            EXPECT_NEAR(chandrasekhar_h(row.number("mu"), std::stod(w)),
                        row.number(std::string("w") + w), 0.51e-9);
        }
    }
    const auto brdf = read_csv("layers/chandrasekhar_brdf.csv");
    ASSERT_EQ(brdf.size(), 180u);
    for (const CsvRow& row : brdf) {
        const double mu = row.number("mu"), mu_0 = row.number("mu0"), w = row.number("w");
        EXPECT_NEAR(chandrasekhar_brdf(mu_0, mu, w), row.number("f_r"), 0.51e-9);
    }
    const auto albedo = read_csv("layers/chandrasekhar_albedo.csv");
    ASSERT_EQ(albedo.size(), 18u);
    for (const CsvRow& row : albedo) {
        const double w = row.number("w");
        EXPECT_NEAR(chandrasekhar_spherical_albedo(w), row.number("As"), 0.51e-8);
        for (int i = 1; i <= 10; ++i) {
            const std::string column =
                "A_mu0_" + (i == 10 ? std::string("1") : "0." + std::to_string(i));
            EXPECT_NEAR(chandrasekhar_plane_albedo(i / 10.0, w), row.number(column), 0.51e-8);
        }
    }
}

TEST(ChandrasekharTest, SolvesItsEquation)
{
    // Chandrasekhar 1950, section 36: 1 / H(mu) = sqrt(1 - w) + (w / 2) times the integral of mu'
    // H(mu') / (mu + mu'). The substitution mu' = x^3 takes H's infinite slope at 0.
    const QuadratureRule rule = gauss_legendre(80);
    for (const double w : {0.3, 0.9, 1 - 1e-7, 1.0}) {
        for (const double mu : {1e-3, 0.1, 0.5, 1.0}) {
            double integral = 0;
            for (Eigen::Index i = 0; i < rule.nodes.size(); ++i) {
                const double x = rule.nodes(i), cosine = x * x * x;
                integral += rule.weights(i) * 3 * x * x * cosine * chandrasekhar_h(cosine, w) /
                            (mu + cosine);
            }
            EXPECT_NEAR(1 / chandrasekhar_h(mu, w), std::sqrt(1 - w) + w / 2 * integral, 1e-9)
                << "w = " << w << ", mu = " << mu;
        }
    }
}

TEST(ChandrasekharTest, KnowsTheLimits)
{
    EXPECT_NEAR(chandrasekhar_h(0.5, 0), 1, 1e-14);
    EXPECT_NEAR(chandrasekhar_h(0, 1), 1, 1e-14);
    EXPECT_NEAR(chandrasekhar_plane_albedo(0.3, 1), 1, 1e-14);
    EXPECT_NEAR(chandrasekhar_spherical_albedo(1), 1, 1e-13);
    // A faint medium scatters once: w / (4 pi (mu + mu0)).
    EXPECT_NEAR(chandrasekhar_brdf(0.3, 0.6, 1e-9) * 1e9, 1 / (4 * std::numbers::pi * 0.9), 1e-9);
}

}  // namespace
}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Directional albedos that other programs have tabulated, of the references.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "reference/albedo_fixtures.hpp"
#include "reference/albedo_rows.hpp"

namespace gonio {
namespace {

/// The lobe with its roughness set by name, and the greatest difference from the row.
double greatest_difference(const Row& row, const char* name, int nodes)
{
    const std::string roughness = std::to_string(row.roughness);
    const Brdf f = reference_of(std::string(row.lobe) + " " + name + "=" + roughness);
    double greatest = 0;
    for (std::size_t k = 0; k < cosines.size(); ++k) {
        const double e = albedo_over_half_vectors(f, cosines[k], row.roughness, nodes);
        greatest = std::max(greatest, std::abs(e - row.albedo[k]));
    }
    return greatest;
}

TEST(AlbedoTableTest, SmithMasking)
{
    for (const Row& row : smith) {
        const int nodes = row.lobe[0] == 'b' ? 48 : 32;
        EXPECT_LT(greatest_difference(row, "alpha", nodes), 6e-8) << row.lobe << row.roughness;
    }
}

// The table is from a quadrature that does not know of the kinks and is right to 1.1e-6.
TEST(AlbedoTableTest, GroovesOfCookTorrance)
{
    for (const Row& row : grooves)
        EXPECT_LT(greatest_difference(row, "m", 32), 1.2e-6) << row.roughness;
}

// The table is right to one unit of its fifth digit.
TEST(AlbedoTableTest, Ward)
{
    for (const Row& row : wards)
        EXPECT_LT(greatest_difference(row, "alpha", 48), 1e-5) << row.lobe << row.roughness;
}

TEST(AlbedoTableTest, MeansOfGgx)
{
    for (const Mean& mean : means) {
        const Brdf f = reference_of("ggx alpha=" + std::to_string(mean.roughness));
        const auto directional = [&](double mu) {
            return albedo_over_half_vectors(f, mu, mean.roughness, 24);
        };
        EXPECT_NEAR(mean_albedo(directional, 32), mean.albedo, 1e-6) << mean.roughness;
    }
}

// E = f0 scale + bias with Schlick's reflectance of facets and alpha = perceptual^2.
TEST(AlbedoTableTest, SplitSum)
{
    for (const SplitSum& at : split_sums) {
        const double alpha = at.perceptual * at.perceptual;
        const auto directional = [&](const char* f0) {
            const Brdf f =
                reference_of("ggx f0=" + std::string(f0) + " alpha=" + std::to_string(alpha));
            return albedo_over_half_vectors(f, at.mu, alpha, 48);
        };
        EXPECT_NEAR(directional("0"), at.bias, 6e-8) << at.perceptual << " " << at.mu;
        EXPECT_NEAR(directional("1"), at.scale + at.bias, 1.2e-7) << at.perceptual << " " << at.mu;
    }
}

struct Simple {
    const char* lobe;
    std::array<double, 8> albedo;
};

constexpr std::array simple{
    Simple{"oren_nayar form=full rho=1 sigma=20",
           {0.94742, 0.94885, 0.95436, 0.97142, 0.99808, 1.02136, 1.03217, 1.0443}},
    Simple{"oren_nayar form=full rho=1 sigma=30",
           {0.88843, 0.8903, 0.89752, 0.91984, 0.95474, 0.98522, 0.99936, 1.01524}},
    Simple{"oren_nayar rho=1 sigma=30",
           {0.77311, 0.8078, 0.83433, 0.87411, 0.91115, 0.93093, 0.9369, 0.94141}},
    Simple{"ashikhmin_shirley exponent=100 r_s=1 r_d=0",
           {0.96117, 0.94052, 0.91077, 0.84594, 0.7185, 0.59528, 0.54828, 0.5097}},
    Simple{"charlie roughness=0.5 c=1",
           {0.08333, 0.11365, 0.16411, 0.26713, 0.41375, 0.55366, 0.62467, 0.71064}},
};

TEST(AlbedoTableTest, OtherLobes)
{
    for (const Simple& row : simple)
        for (std::size_t k = 0; k < cosines.size(); ++k)
            EXPECT_NEAR(albedo(reference_of(row.lobe), cosines[k], 96), row.albedo[k], 6e-6)
                << row.lobe << " at " << cosines[k];
}

// Published models that gain energy at grazing light: how much.
TEST(AlbedoTableTest, KnownGains)
{
    const auto grazing = [](const char* lobe) { return albedo(reference_of(lobe), 0.01, 96); };
    EXPECT_NEAR(grazing("burley rho=1 roughness=1"), 1.538, 5e-4);
    EXPECT_NEAR(grazing("burley rho=1 roughness=0.5"), 1.008, 5e-4);
    EXPECT_NEAR(grazing("charlie c=1 roughness=0.1"), 1.236, 5e-4);
    EXPECT_NEAR(grazing("oren_nayar form=full rho=1 sigma=5"), 1.0113, 5e-5);
    EXPECT_NEAR(grazing("oren_nayar form=full rho=1 sigma=10"), 1.0326, 5e-5);
    EXPECT_NEAR(grazing("oren_nayar rho=1 sigma=10"), 1.014, 5e-4);
    const Brdf ward = reference_of("ward form=duer rho_s=1 alpha=0.5");
    EXPECT_NEAR(albedo_over_half_vectors(ward, 0.01, 0.5, 48), 8.71, 5e-3);
}

}  // namespace
}  // namespace gonio

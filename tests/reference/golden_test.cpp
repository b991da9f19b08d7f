// SPDX-License-Identifier: Apache-2.0
// The references against values that an independent program computed, to every printed digit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/params.hpp"
#include "reference/reference_fixtures.hpp"
#include "reference/wave_series.hpp"

namespace gonio {
namespace {

std::string nine_digits(double value)
{
    return fmt::format("{:.9g}", value);
}

TEST(GoldenTest, EveryPrintedDigit)
{
    for (const Golden& golden : golden_values()) {
        const Brdf f = reference_of(golden.lobe, golden.measure);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [l, v] = golden_geometries()[k];
            const double value = f(l, v);
            // A printed 0 may be what rounding leaves of directions that meet exactly.
            EXPECT_EQ(nine_digits(value < 1e-30 ? 0 : value), golden.printed[k])
                << golden.lobe << ", column " << k;
        }
    }
}

TEST(GoldenTest, DiffuseLobeOfAshikhminShirley)
{
    const std::array<const char*, 4> printed{"0.0515138281", "0.0494046544", "0.00423705493",
                                             "0.0379526756"};
    const Brdf both = reference_of("ashikhmin_shirley n_u=20 n_v=50 r_s=0.5 r_d=0.3");
    const Brdf specular = reference_of("ashikhmin_shirley n_u=20 n_v=50 r_s=0.5 r_d=0");
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [l, v] = golden_geometries()[k];
        EXPECT_EQ(nine_digits(both(l, v) - specular(l, v)), printed[k]);
    }
}

// The diffuse part stands alone more than 90 degrees from the mirror direction.
TEST(GoldenTest, PartsOfStrauss)
{
    const std::array<const char*, 4> diffuse{"0.340997503", "0.278423295", "0.06837397",
                                             "0.196875"};
    const std::array<const char*, 4> specular{"0.102450814", "0.0469572928", "0.13849067", "0"};
    const Brdf f = reference_of("strauss smoothness=0.5 metalness=0.5 c=0.6", Measure::as_printed);
    const std::array<double, 4> azimuth{0, 0, 10, 40};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [l, v] = golden_geometries()[k];
        const double alone = f(l, direction(80, azimuth[k]));
        EXPECT_EQ(nine_digits(alone), diffuse[k]);
        EXPECT_EQ(nine_digits(f(l, v) - alone), specular[k]);
    }
}

TEST(GoldenTest, WaveSeries)
{
    const std::array<const char*, 4> smooth{"0.330293148", "0.0371789085", "0.0317159953",
                                            "3.04654152e-09"};
    const std::array<const char*, 4> rough{"0.0103231316", "0.00584912277", "0.0109537624",
                                           "1.95190957e-09"};
    const auto series = [](double sigma, double tau, const Geometry& at) {
        const double k = 2 * std::numbers::pi / 0.55;
        const glm::dvec3 sum = at.l + at.v;
        const double g = std::pow(sigma * k * sum.z, 2);
        const double b = std::pow(tau * k, 2) * (sum.x * sum.x + sum.y * sum.y) / 4;
        return reference::wave_series(g, b);
    };
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(nine_digits(series(0.1, 1, golden_geometries()[k])), smooth[k]);
        EXPECT_EQ(nine_digits(series(0.5, 3, golden_geometries()[k])), rough[k]);
    }
}

}  // namespace
}  // namespace gonio

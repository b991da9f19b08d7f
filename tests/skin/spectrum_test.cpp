// SPDX-License-Identifier: Apache-2.0
// Spectra of skin against Monte Carlo of another program, and against their own error bound.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/csv.hpp"
#include "reference/z_test.hpp"
#include "skin/skin_fixtures.hpp"

namespace gonio {
namespace {

using test::CsvRow;
using test::read_csv;
using test::skin_of;

/// An upper bound of the standard error of a fraction: that of counting whole photons.
double counting_error(double fraction, double photons)
{
    return std::sqrt(std::max(fraction * (1 - fraction), 1 / photons) / photons);
}

/// Every row: what returns, what goes through, and what each layer keeps.
void compare(const std::string& file, std::size_t photons, const LightSource& light)
{
    test::ZTest test;
    for (const CsvRow& row : read_csv(file)) {
        const std::string name = row.text("model") + " " + row.text("lambda_nm");
        const auto spectrum =
            solve_skin({skin_of(row.text("model"))}, {row.number("lambda_nm")}, light, 2e-5)[0];
        test.add(name + " R", {row.number("R"), row.number("se")},
                 spectrum.reflectance[0] - spectrum.specular[0], photons);
        const auto add = [&](const std::string& column, double expected) {
            const double mean = row.number(column);
            test.add(name + " " + column, {mean, counting_error(mean, double(photons))}, expected,
                     photons);
        };
        add("T", spectrum.transmittance[0]);
        for (std::size_t k = 0; k < spectrum.absorption.size(); ++k)
            add("A" + std::to_string(k + 1), spectrum.absorption[k][0]);
    }
    test.expect_only_noise();
}

TEST(SkinSpectra, AgreeWithMonteCarlo)
{
    compare("layers/skin_monte_carlo_normal.csv", 200'000, {});
    compare("layers/skin_monte_carlo_diffuse.csv", 100'000, {.beam = Beam::diffuse});
}

TEST(SkinSpectra, KeepTheirErrorBoundAndTheEnergy)
{
    for (const auto* name : {"jacques1998_light", "meglinski2002_A_mel2", "delgado2011_bil0.1"}) {
        const std::vector<double> wavelengths{420, 542, 577, 700};
        const auto rough = solve_skin({skin_of(name)}, wavelengths, {}, 1e-4)[0];
        const auto fine = solve_skin({skin_of(name)}, wavelengths, {}, 1e-7)[0];
        for (std::size_t k = 0; k < wavelengths.size(); ++k) {
            EXPECT_LE(rough.error, 1e-4);
            EXPECT_NEAR(rough.reflectance[k], fine.reflectance[k], rough.error);
            double sum = rough.reflectance[k] + rough.transmittance[k] + rough.bottom[k];
            for (const auto& layer : rough.absorption) sum += layer[k];
            EXPECT_NEAR(sum, 1, 1e-9) << name;
        }
    }
}

// Fresnel at normal incidence: ((1.4 - 1) / (1.4 + 1))^2.
TEST(SkinSpectra, TellWhatTheSurfaceReflects)
{
    const auto spectrum = solve_skin({skin_of("jacques1998_dark")}, {500}, {}, 1e-4)[0];
    EXPECT_NEAR(spectrum.specular[0], 1.0 / 36, 1e-12);
    EXPECT_GT(spectrum.reflectance[0], spectrum.specular[0]);
}

}  // namespace
}  // namespace gonio

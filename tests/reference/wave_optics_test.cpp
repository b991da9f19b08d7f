// SPDX-License-Identifier: Apache-2.0
// The wave-optics models in the limits in which other theories give the answer.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "reference/albedo_fixtures.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

// What geometrical optics sees: facets of m = 2 sigma/tau = 0.2, and g of about 1e7.
const std::string rough = " wavelength=200 sigma=100 tau=1000";

const std::array<Geometry, 4> around_the_mirror{{{direction(30, 0), direction(30, 180)},
                                                 {direction(45, 0), direction(20, 150)},
                                                 {direction(60, 10), direction(65, 180)},
                                                 {direction(5, 0), direction(8, 70)}}};

/// g of the rough surface
double phase_variance(const Geometry& at)
{
    return std::pow(2 * pi * 100 / 0.2 * (at.l.z + at.v.z), 2);
}

// D of Beckmann's facets over 4 (n.l)(n.v): Torrance & Sparrow without masking.
TEST(WaveOpticsTest, RoughSurfacesAreFacets)
{
    const Brdf wave = reference_of("beckmann_kirchhoff" + rough);
    const Brdf facets = reference_of("torrance_sparrow ndf=beckmann masking=v_cavity alpha=0.2");
    for (const auto& at : around_the_mirror) {
        const glm::dvec3 h = at.l + at.v;
        const double length = std::sqrt(h.x * h.x + h.y * h.y + h.z * h.z);
        const double masked = std::min(1.0, 4 * h.z / (length * length) * std::min(at.l.z, at.v.z));
        EXPECT_NEAR(wave(at.l, at.v) / facets(at.l, at.v) * masked, 1, 200 / phase_variance(at));
    }
}

// The shadowing of He et al. is 1 here but for erfc(tau cot(theta)/(2 sigma)).
TEST(WaveOpticsTest, ShadowingOfHeTorranceIsOneFarFromGrazing)
{
    const Brdf he = reference_of("he_torrance" + rough);
    const Brdf bare = reference_of("beckmann_kirchhoff" + rough);
    for (const auto& at : around_the_mirror)
        EXPECT_NEAR(he(at.l, at.v) / bare(at.l, at.v), 1, 2e-3);
}

// Smith 1967: (1 - erfc(a)/2)/(1 + Lambda(a)) for each direction, a = cot(theta)/slope, and the
// height deviation of the visible parts, He et al. 1991, eqs. 80 to 83, here solved by bisection.
TEST(WaveOpticsTest, HeTorranceIsBeckmannKirchhoffOfTheVisibleSurface)
{
    const double tau = 3, sigma = 0.5;
    const auto shadowing = [&](glm::dvec3 w) {
        const double a = tau * w.z / (2 * sigma * std::sqrt(1 - w.z * w.z));
        const double lambda = (std::exp(-a * a) / (a * std::sqrt(pi)) - std::erfc(a)) / 2;
        return (1 - std::erfc(a) / 2) / (1 + lambda);
    };
    const auto hidden = [&](glm::dvec3 w) {
        const double tan = std::sqrt(1 - w.z * w.z) / w.z;
        return tan * std::erfc(tau / (2 * sigma * tan));
    };
    for (const auto& [l, v] : golden_geometries()) {
        const double goal = (hidden(l) + hidden(v)) / std::sqrt(8 * pi);
        double low = 0, high = 10;
        for (int k = 0; k < 60; ++k) {
            const double x = (low + high) / 2;
            (x * std::exp(x * x / 2) < goal ? low : high) = x;
        }
        const double visible = sigma / std::sqrt(1 + low * low);
        char text[100];
        std::snprintf(text, sizeof text, "beckmann_kirchhoff tau=3 sigma=%.17g", visible);
        const double expected = shadowing(l) * shadowing(v) * reference_of(text)(l, v);
        EXPECT_NEAR(reference_of("he_torrance tau=3 sigma=0.5")(l, v) / expected, 1, 1e-12);
    }
}

// 4 pi^2/lambda^4 (n.l + n.v)^2 PSD, PSD = pi sigma^2 tau^2 exp(-(pi tau f)^2): Krywonos et al.
// 2011 in the limit of smooth surfaces; Rayleigh & Rice have 4 (n.l)(n.v) for (n.l + n.v)^2.
TEST(WaveOpticsTest, SmoothSurfacesShowTheirPowerSpectrum)
{
    const double sigma = 1e-30, tau = 1, lambda = 0.5;
    const Brdf wave = reference_of("harvey_shack wavelength=500 sigma=1e-30 tau=1");
    for (const auto& [l, v] : golden_geometries()) {
        const double f = std::hypot(l.x + v.x, l.y + v.y) / lambda;
        const double psd = pi * std::pow(sigma * tau * std::exp(-std::pow(pi * tau * f, 2) / 2), 2);
        const double expected = 4 * pi * pi / std::pow(lambda, 4) * std::pow(l.z + v.z, 2) * psd;
        EXPECT_NEAR(wave(l, v) / expected, 1, 1e-8);
    }
}

// Where g does not depend on v, what is scattered is what the mirror direction lacks.
TEST(WaveOpticsTest, TotalIntegratedScatter)
{
    const auto scattered = [](const std::string& form, double sigma, double mu) {
        const std::string surface = " wavelength=500 tau=20 sigma=" + std::to_string(sigma);
        return albedo_over_half_vectors(reference_of("harvey_shack form=" + form + surface), mu,
                                        0.01, 64);
    };
    const auto missing = [](double sigma, double mu) {
        return 1 - std::exp(-std::pow(4 * pi * sigma * mu / 0.5, 2));
    };
    for (const double sigma : {0.01, 0.1}) {
        EXPECT_NEAR(scattered("original", sigma, 1), missing(sigma, 1), 1e-9) << sigma;
        EXPECT_NEAR(scattered("original", sigma, 0.8), missing(sigma, 1), 1e-9) << sigma;
        EXPECT_NEAR(scattered("modified", sigma, 0.8), missing(sigma, 0.8), 1e-9) << sigma;
    }
}

// What a polished surface does not scatter stays in the mirror direction.
TEST(WaveOpticsTest, FlatSurfacesScatterNothing)
{
    for (const char* model :
         {"beckmann_kirchhoff", "vernold_harvey", "he_torrance", "harvey_shack"})
        for (const auto& [l, v] : golden_geometries())
            EXPECT_EQ(reference_of(std::string(model) + " sigma=0")(l, v), 0) << model;
}

}  // namespace
}  // namespace gonio

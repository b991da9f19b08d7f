// SPDX-License-Identifier: Apache-2.0
// Beams with a width: where they arrive behind a window that does nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "gonio/errors.hpp"
#include "photon/photon_fixtures.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

constexpr std::uint64_t photons = 400'000;
constexpr std::size_t rows = 12;
constexpr double radius = 0.5, width = 0.1;

std::vector<Fraction> arriving(LightSource light)
{
    PhotonRequest request = photon_request(photons, light);
    request.tallies = {.transmitted = true, .radius_width = width, .rows = rows};
    return simulate_photons(in_air({layer(1, 0, 0, 0, 1e-6)}), request, photons).transmitted;
}

/// within: the part of the beam closer than r to its axis.
template <class Within>
void expect_profile(LightSource light, Within within)
{
    ZTest test;
    const auto found = arriving(light);
    for (std::size_t k = 0; k <= rows; ++k) {
        const double inner = within(double(k) * width);
        const double outer = k == rows ? 1 : within(double(k + 1) * width);
        test.add("ring " + std::to_string(k), estimate(found[k]), outer - inner, photons);
    }
    test.expect_only_noise();
}

TEST(PhotonSources, SpreadAsTheirProfilesSay)
{
    expect_profile({.beam = Beam::gaussian, .radius = radius},
                   [](double r) { return -std::expm1(-2 * std::pow(r / radius, 2)); });
    expect_profile({.beam = Beam::top_hat, .radius = radius},
                   [](double r) { return std::min(1.0, std::pow(r / radius, 2)); });
    expect_profile({.beam = Beam::pencil}, [](double r) { return r > 0 ? 1.0 : 0.0; });
}

/// An ellipse, longer along x by the cosine: the part of it in a circle, by a sum over its area.
TEST(PhotonSources, SpreadOnASlant)
{
    const double stretch = 1 / std::cos(radians(60));
    expect_profile({.beam = Beam::top_hat, .incidence = radians(60), .radius = radius},
                   [&](double r) {
                       constexpr int steps = 2000;
                       int inside = 0, all = 0;
                       for (int i = 0; i < steps; ++i)
                           for (int k = 0; k < steps; ++k) {
                               const double x = (i + 0.5) / steps, y = (k + 0.5) / steps;
                               if (x * x + y * y > 1) continue;
                               ++all;
                               inside += std::hypot(x * stretch, y) * radius < r ? 1 : 0;
                           }
                       return double(inside) / all;
                   });
}

TEST(PhotonSources, RefuseARadiusBelowZero)
{
    EXPECT_THROW(arriving({.beam = Beam::gaussian, .radius = -1}), UsageError);
}

}  // namespace
}  // namespace gonio::test

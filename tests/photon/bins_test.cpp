// SPDX-License-Identifier: Apache-2.0
// Bins of angle, radius and depth, against the exact solution and the scalar Monte Carlo.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "photon/photon_fixtures.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/layered_media.hpp"
#include "reference/light_budgets.hpp"
#include "reference/scalar_monte_carlo.hpp"

namespace gonio::test {
namespace {

TEST(PhotonBins, HoldTheExactAngles)
{
    constexpr std::size_t bins = 18, photons = 1'000'000;
    const LayeredMedium medium = van_de_hulst_slab(1.3);
    PhotonRequest request = photon_request(photons);
    request.tallies = {.reflected = true, .transmitted = true, .angles = bins};
    const PhotonResult result = simulate_photons(medium, request, photons);
    AngularBins exact = exact_angular_bins(medium, bins);
    // Of what is reflected at the bottom and leaves unscattered, the exact budget knows.
    exact.transmitted[0] += exact.budget.unscattered_transmittance;
    exact.reflected[0] += exact.budget.diffuse_reflectance -
                          std::accumulate(exact.reflected.begin(), exact.reflected.end(), 0.0);
    ZTest test;
    for (std::size_t i = 0; i < bins; ++i) {
        test.add("reflected " + std::to_string(i), estimate(result.reflected[i]),
                 exact.reflected[i], photons);
        test.add("transmitted " + std::to_string(i), estimate(result.transmitted[i]),
                 exact.transmitted[i], photons);
    }
    test.expect_only_noise();
}

TEST(PhotonBins, HoldBeersLaw)
{
    constexpr std::size_t bins = 20, photons = 1'000'000;
    PhotonRequest request = photon_request(photons, {.incidence = radians(30)});
    request.tallies = {.absorbed = true, .depth_width = 0.02, .depths = bins};
    const PhotonResult result =
        simulate_photons(in_air({layer(1.4, 5, 0, 0, infinite)}), request, photons);
    const double sine = 0.5 / 1.4, attenuation = 5 / std::sqrt(1 - sine * sine);
    const double entered = 1 - result.specular.mean;
    ZTest test;
    for (std::size_t i = 0; i < bins; ++i)
        test.add(
            "depth " + std::to_string(i), estimate(result.absorbed[i]),
            entered * std::exp(-attenuation * double(i) * 0.02) * -std::expm1(-attenuation * 0.02),
            photons);
    test.add("deeper", estimate(result.absorbed[bins]),
             entered * std::exp(-attenuation * bins * 0.02), photons);
    test.expect_only_noise();
}

/// The difference of two simulations must be noise.
void add_difference(ZTest& test, const std::string& name, const Fraction& ours,
                    const reference::Estimate& other, std::size_t photons)
{
    if (ours.mean == 0 && other.mean == 0) return;
    test.add(name, {ours.mean - other.mean, std::hypot(ours.error, other.error)}, 0, photons);
}

TEST(PhotonBins, AgreeWithTheScalarMonteCarlo)
{
    constexpr std::size_t photons = 400'000, scalar_photons = 40'000;
    const LayeredMedium medium = mcml_sample();
    const reference::MonteCarloRequest scalar{.photons = scalar_photons,
                                              .batches = 200,
                                              .dr = 0.05,
                                              .dz = 0.05,
                                              .r_bins = 5,
                                              .z_bins = 7};
    const reference::MonteCarloResult expected = reference::simulate(medium, scalar);
    PhotonRequest request = photon_request(photons);
    request.tallies = {.reflected = true,
                       .transmitted = true,
                       .absorbed = true,
                       .radius_width = 0.05,
                       .depth_width = 0.05,
                       .rows = 5,
                       .depths = 7,
                       .absorbed_radii = 5};
    const PhotonResult result = simulate_photons(medium, request, photons);
    ZTest test;
    for (std::size_t r = 0; r <= 5; ++r) {
        const auto at = std::to_string(r);
        add_difference(test, "R(r) " + at, result.reflected[r], expected.reflected_r[r], photons);
        add_difference(test, "T(r) " + at, result.transmitted[r], expected.transmitted_r[r],
                       photons);
    }
    for (std::size_t k = 0; k < result.absorbed.size(); ++k)
        add_difference(test, "A(z, r) " + std::to_string(k), result.absorbed[k],
                       expected.absorbed_zr[k], photons);
    test.expect_only_noise();
}

/// 64-bit sums: what the bins hold is what the totals hold, to the last unit.
TEST(PhotonBins, AddUpToTheTotals)
{
    constexpr std::uint64_t photons = 1 << 14;
    LayeredMedium medium = mcml_sample();
    medium.bottom = Bottom::diffuse;
    medium.bottom_albedo = 0.3;
    PhotonRequest request = photon_request(photons);
    request.tallies = {.reflected = true,
                       .absorbed = true,
                       .rows = 10,
                       .angles = 9,
                       .depths = 30,
                       .absorbed_radii = 10};
    const PhotonResult result = simulate_photons(medium, request, photons);
    const auto sum = [](const std::vector<Fraction>& all) {
        double whole = 0;
        for (const Fraction& one : all) whole += one.mean;
        return whole;
    };
    // Sums of multiples of 2^-44 below 1 are exact in double.
    EXPECT_EQ(sum(result.reflected), result.diffuse_reflectance.mean);
    EXPECT_EQ(sum(result.absorbed), sum(result.absorption));
    EXPECT_EQ(sum(result.absorption) + result.specular.mean + result.diffuse_reflectance.mean +
                  result.unscattered_transmittance.mean + result.diffuse_transmittance.mean +
                  result.bottom_absorption.mean + result.took.mean,
              1 + result.gave.mean);
}

}  // namespace
}  // namespace gonio::test

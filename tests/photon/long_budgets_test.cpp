// SPDX-License-Identifier: Apache-2.0
// Budgets of so many photons that a bias of 1e-5 would show.
#include <gtest/gtest.h>

#include <cstdio>
#include <tuple>

#include "photon/photon_fixtures.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

/// The digits of adding-doubling in double with 96 nodes; the slab's first are van de Hulst's of
/// 1980, table 35.
void compare(const LayeredMedium& medium, std::uint64_t photons, double reflected, double scattered)
{
    const PhotonResult result = simulate_photons(medium, photon_request(photons), photons);
    ZTest test;
    test.add("reflected", estimate(result.diffuse_reflectance), reflected, photons);
    test.add("transmitted, scattered", estimate(result.diffuse_transmittance), scattered, photons);
    test.expect_only_noise();
    for (const auto& [name, found, exact] :
         {std::tuple{"reflected", result.diffuse_reflectance, reflected},
          std::tuple{"transmitted, scattered", result.diffuse_transmittance, scattered}})
        std::printf("%s %.8f +- %.1e, exact %.8f: %+.1f standard errors\n", name, found.mean,
                    found.error, exact, (found.mean - exact) / found.error);
}

TEST(LongPhotonBudgets, OfTheSlab)
{
    compare(van_de_hulst_slab(), 1'000'000'000, .09739464, .66095770 - .13533528);
}

TEST(LongPhotonBudgets, OfMcmlsSample)
{
    compare(mcml_sample(), 100'000'000, .23785625, .09604772);
}

TEST(LongPhotonBudgets, OfSkin)
{
    compare(seven_layer_skin(), 30'000'000, .56258497, .00326340);
}

}  // namespace
}  // namespace gonio::test

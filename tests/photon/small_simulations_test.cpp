// SPDX-License-Identifier: Apache-2.0
// Simulations of a few photons that use all of the kernel, also for Oclgrind.
#include <gtest/gtest.h>

#include "photon/photon_fixtures.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

LayeredMedium medium(Bottom bottom)
{
    LayeredMedium all = layers_over(bottom);
    all.layers.insert(all.layers.begin(), layer(1.5, 0, 0, 0, 0.01));
    const std::vector<PhaseFunction> phases = {Isotropic{}, Rayleigh{},
                                               TwoTermHenyeyGreenstein{0.9, -0.5, 0.7},
                                               TabulatedPhase{{-1, 0, 1}, {1, 0, 3}}};
    for (const PhaseFunction& phase : phases)
        all.layers.push_back({.mua = 1, .mus = 20, .n = 1.3, .d = 0.02, .phase = phase});
    return all;
}

TEST(SmallSimulations, LoseNoLight)
{
    constexpr std::uint64_t photons = 64;
    const std::vector<LightSource> lights = {{.beam = Beam::gaussian, .radius = 0.1},
                                             {.beam = Beam::top_hat, .incidence = 1, .radius = 0.1},
                                             {.beam = Beam::diffuse}};
    const std::vector<Bottom> bottoms = {Bottom::open, Bottom::mirror, Bottom::diffuse};
    const std::vector<ExitRow> rows = {ExitRow::time, ExitRow::azimuth, ExitRow::radius};
    for (std::size_t k = 0; k < lights.size(); ++k) {
        PhotonRequest request{.light = lights[k], .batch = 16};
        request.tallies = {.reflected = true,
                           .transmitted = true,
                           .absorbed = true,
                           .row = rows[k],
                           .rows = 3,
                           .angles = 3,
                           .depths = 3,
                           .absorbed_radii = 3};
        if (rows[k] == ExitRow::radius)
            request.tallies.spectrum.assign(3, std::vector<double>(7, 2.0));
        const PhotonResult result = simulate_photons(medium(bottoms[k]), request, photons);
        double ended = result.specular.mean + result.diffuse_reflectance.mean +
                       result.unscattered_transmittance.mean + result.diffuse_transmittance.mean +
                       result.bottom_absorption.mean + result.unfinished.mean + result.took.mean;
        for (const Fraction& absorbed : result.absorption) ended += absorbed.mean;
        // Multiples of 2^-36 below 2 add up exactly in double.
        EXPECT_EQ(ended, 1 + result.gave.mean) << k;
    }
}

}  // namespace
}  // namespace gonio::test

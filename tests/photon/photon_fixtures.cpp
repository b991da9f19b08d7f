// SPDX-License-Identifier: Apache-2.0
// Simulations that several tests of photons run, and what they must give.
#include "photon/photon_fixtures.hpp"

#include <algorithm>

#include "reference/adding_doubling.hpp"

namespace gonio::test {

reference::Estimate estimate(const Fraction& fraction)
{
    return {fraction.mean, fraction.error};
}

PhotonRequest photon_request(std::uint64_t photons, LightSource light)
{
    return {.light = light, .batch = std::max<std::uint64_t>(2, photons / 200)};
}

PhotonResult simulate_photons(const LayeredMedium& medium, const PhotonRequest& request,
                              std::uint64_t photons)
{
    PhotonTracer tracer(Device(), medium, request);
    tracer.trace(photons);
    return tracer.result();
}

void compare_with_exact(ZTest& test, const std::string& name, const LayeredMedium& medium,
                        std::uint64_t photons, LightSource light)
{
    const auto solution =
        reference::solve_layers_to(medium, {.incidence = {light.incidence}}, 2e-5);
    const auto& exact = (light.diffuse ? solution.diffuse : solution.collimated[0]).budget;
    const PhotonResult result = simulate_photons(medium, photon_request(photons, light), photons);
    const auto add = [&](const std::string& part, const Fraction& measured, double expected) {
        // A device's specular reflectance without chance is rounded to 2^-30.
        if (measured.error < 1e-12 && std::abs(measured.mean - expected) < 0x1p-30) return;
        test.add(name + ": " + part, estimate(measured), expected, photons);
    };
    add("specular", result.specular, exact.specular);
    add("diffuse reflectance", result.diffuse_reflectance, exact.diffuse_reflectance);
    add("unscattered transmittance", result.unscattered_transmittance,
        exact.unscattered_transmittance);
    add("diffuse transmittance", result.diffuse_transmittance, exact.diffuse_transmittance);
    add("bottom", result.bottom_absorption, exact.bottom_absorption);
    for (std::size_t i = 0; i < exact.absorption.size(); ++i)
        add("layer " + std::to_string(i + 1), result.absorption[i], exact.absorption[i]);
    EXPECT_EQ(result.unfinished.mean, 0) << name;
}

}  // namespace gonio::test

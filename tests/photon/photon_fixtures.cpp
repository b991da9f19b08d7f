// SPDX-License-Identifier: Apache-2.0
// Simulations that several tests of photons run, and what they must give.
#include "photon/photon_fixtures.hpp"

#include <algorithm>

#include "reference/adding_doubling.hpp"
#include "reference/light_budgets.hpp"

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
    const auto& exact = solution.under(light).budget;
    const PhotonResult result = simulate_photons(medium, photon_request(photons, light), photons);
    const auto add = [&](const std::string& part, const Fraction& measured, double expected) {
        // A device's specular reflectance without chance is rounded to 2^-30.
        if (measured.error < 1e-12 && std::abs(measured.mean - expected) < 0x1p-30) return;
        test.add(name + ": " + part, estimate(measured), expected, photons);
    };
    for_each_part(result, exact, add);
    EXPECT_EQ(result.unfinished.mean, 0) << name;
}

}  // namespace gonio::test

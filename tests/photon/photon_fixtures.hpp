// SPDX-License-Identifier: Apache-2.0
// Simulations that several tests of photons run, and what they must give.
#pragma once

#include <string>

#include "gonio/photons.hpp"
#include "reference/z_test.hpp"

namespace gonio::test {

/// The z-test wants many batches, so that their spread is known to 5 % and the deviations are close
/// to normal.
PhotonRequest photon_request(std::uint64_t photons, LightSource light = {});

/// On the default device.
PhotonResult simulate_photons(const LayeredMedium& medium, const PhotonRequest& request,
                              std::uint64_t photons);

/// Simulates, solves by adding-doubling, and adds all of the budget to the test.
void compare_with_exact(ZTest& test, const std::string& name, const LayeredMedium& medium,
                        std::uint64_t photons, LightSource light = {});

reference::Estimate estimate(const Fraction& fraction);

}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// Monte Carlo in layered media, one photon at a time and in double precision: the yardstick for the
// accuracy and the speed of faster ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gonio/layers.hpp"
#include "reference/batch_scores.hpp"

namespace gonio::reference {

/// What to simulate, and the bins.
struct MonteCarloRequest {
    std::size_t photons = 100'000;
    std::uint64_t seed = 1;
    /// Where numbers in (0, 1) come from; empty: the Mersenne Twister, by the seed.
    std::function<double()> uniform = {};
    /// Gets a photon's number before it draws its own first one; may be empty.
    std::function<void(std::size_t)> before_photon = {};
    bool diffuse = false;  ///< Lambertian light, else a pencil beam
    double incidence = 0;  ///< of the pencil beam, towards +x; rad from the normal, in [0, pi / 2)

    std::size_t batches = 50;        ///< of equal size; their spread gives the errors. At least 2
    double roulette_below = 1e-4;    ///< a photon that is lighter than this lives on
    double roulette_survival = 0.1;  ///< with this probability
    /// A photon is absorbed whole or not at all, instead of losing weight.
    bool analogue = false;
    /// Draws a number where it decides nothing, too, as MCML does: between equal indices and where
    /// all light is reflected. The order of numbers shows where their generator is bad.
    bool draws_at_all_boundaries = false;
    std::size_t most_steps = 10'000'000;  ///< of one photon; what it carries then is `unfinished`

    double dr = 0.01, dz = 0.01;                            ///< bin widths, cm
    std::size_t r_bins = 50, z_bins = 50, alpha_bins = 30;  ///< alpha: 0 to 90 degrees
};

/// Fractions of the incident light, with standard errors.
struct MonteCarloResult {
    // Where light ends, as in LightBudget. The means, with those of `unfinished`, add up to 1 +
    // `roulette`.
    Estimate specular, diffuse_reflectance;
    Estimate unscattered_transmittance, diffuse_transmittance;
    std::vector<Estimate> absorption;  ///< in each layer
    Estimate bottom_absorption;
    Estimate unfinished;
    Estimate roulette;  ///< what it gave less what it took

    // Light that was scattered, by where and how it leaves; one more bin of r takes the overflow.
    std::vector<Estimate> reflected_r, reflected_alpha;
    std::vector<Estimate> transmitted_r, transmitted_alpha;
    // Absorption by depth, and by depth and radius ([z][r], r fastest); one more bin of each takes
    // the overflow.
    std::vector<Estimate> absorbed_z, absorbed_zr;
};

/// Wang, Jacques and Zheng, MCML, Comput. Methods Programs Biomed. 47, 1995, with oblique and
/// diffuse incidence, all phase functions and all bottoms. Throws UsageError as validate() does.
MonteCarloResult simulate(const LayeredMedium& medium, const MonteCarloRequest& request);

}  // namespace gonio::reference

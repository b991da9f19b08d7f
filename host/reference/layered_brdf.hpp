// SPDX-License-Identifier: Apache-2.0
// The BRDF of layered media without noise.
#pragma once

#include <vector>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/refinement.hpp"

namespace gonio::reference {

/// A BRDF at all combinations of some angles.
struct LayeredBrdf {
    std::vector<double> values;  ///< 1/sr, row-major, [theta_i][theta_o][delta_phi]
    double error = 0;            ///< of the worst value, from a solution with fewer nodes
    int modes = 0;               ///< Fourier modes over the azimuth that were summed
    int nodes = 0;               ///< quadrature directions asked for
};

/// Of the light that the layers scatter, at angles in rad; the azimuth is 0 on the side of the
/// mirror direction. Adding-doubling with about `nodes` quadrature directions, once for each mode:
/// the sharper the phase functions are, the more of both it takes. Throws UsageError as validate()
/// does, and for angles to the normal outside [0, pi / 2).
LayeredBrdf layered_brdf(const LayeredMedium& medium, const std::vector<double>& theta_i,
                         const std::vector<double>& theta_o, const std::vector<double>& delta_phi,
                         int nodes);

/// Raises the number of nodes until the error is at most `tolerance` of the largest value, or
/// goes_on says no. Throws RunError where 256 are not enough, unless the tolerance is 0.
LayeredBrdf layered_brdf_to(
    const LayeredMedium& medium, const std::vector<double>& theta_i,
    const std::vector<double>& theta_o, const std::vector<double>& delta_phi, double tolerance,
    const AfterPart& after_part = [](double) {}, const GoesOn& goes_on = goes_on_always);

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Scattering angles by inversion of the phase function's distribution.
#pragma once

#include <vector>

#include "gonio/layers.hpp"

namespace gonio::reference {

/// Turns a uniform random number into the cosine of a scattering angle.
class CosineSampler {
public:
    explicit CosineSampler(const PhaseFunction& phase);

    /// The cosine below which the phase function has the fraction `u` of its integral, u in [0, 1];
    /// for the two-term function u first chooses the term.
    double operator()(double u) const;

private:
    PhaseFunction phase_;
    std::vector<double> cumulative_;  ///< of a tabulated function, at its points
};

}  // namespace gonio::reference

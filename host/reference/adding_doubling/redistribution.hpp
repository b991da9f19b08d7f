// SPDX-License-Identifier: Apache-2.0
// Scattering as a quadrature can resolve it: from cosine to cosine, for one azimuth mode.
#pragma once

#include <Eigen/Core>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/directions.hpp"

namespace gonio::reference {

/// A phase function without its peaks, as far as a layer's directions can integrate it.
struct TruncatedPhase {
    double forward, backward;  ///< fractions in deltas straight on and straight back
    Eigen::VectorXd moments;   ///< Legendre moments of the smooth rest, the first 1

    double rest() const { return 1 - forward - backward; }
};
TruncatedPhase truncate(const PhaseFunction& phase, const LocalDirections& directions);

/// Peaks of the phase function that are too narrow for the quadrature are deltas: what they scatter
/// forward counts as not scattered, what they scatter straight back as retro-reflected.
struct Redistribution {
    double scattering;  ///< coefficient of the smooth rest, 1/cm
    double retro;       ///< coefficient of the backward delta, 1/cm
    /// Of the smooth rest, per unit cosine, between two directions of one hemisphere and of two.
    Eigen::MatrixXd forward, backward;
};

/// For the part of the light that goes as cos(mode phi). In mode 0 the quadrature integrates the
/// smooth rest to 1 exactly, from every direction.
Redistribution redistribute(const Layer& layer, const LocalDirections& directions, int mode);

}  // namespace gonio::reference

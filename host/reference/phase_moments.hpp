// SPDX-License-Identifier: Apache-2.0
// Legendre moments of phase functions.
#pragma once

#include <Eigen/Core>

#include "gonio/layers.hpp"

namespace gonio::reference {

/// The mean of the Legendre polynomial P_l over the cosine of the scattering angle, for l = 0 to
/// count - 1. The first is 1, the second the mean cosine. Exact for every kind, tables included.
Eigen::VectorXd legendre_moments(const PhaseFunction& phase, int count);

}  // namespace gonio::reference

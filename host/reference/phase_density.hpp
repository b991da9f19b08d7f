// SPDX-License-Identifier: Apache-2.0
// Phase functions as densities.
#pragma once

#include "gonio/layers.hpp"

namespace gonio::reference {

/// Per solid angle, 1/sr, at a cosine of the scattering angle; over the sphere it adds up to 1.
double phase_density(const PhaseFunction& phase, double cosine);

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// How far what pictures take for light in layers is from what it is.
#pragma once

#include "gonio/device.hpp"
#include "gonio/layers.hpp"
#include "gonio/profile.hpp"

namespace gonio {

/// Of the light up to 8 mm from the edge of a half-plane of light, that spreads by Gaussians in
/// pixels 0.2 mm wide, the largest difference to the photons' own integral over the half-plane; of
/// 1 where all is lit.
double error_behind_an_edge(const Device& device, const SumOfGaussians& gaussians,
                            const RadialProfile& photons);

/// Of rho(mu_i) rho(mu_o)/(pi mean) in place of the layers' BRDF, up to 60 degrees from the normal:
/// the largest relative difference to the solved one.
double error_of_separable_shape(const LayeredMedium& layers);

}  // namespace gonio

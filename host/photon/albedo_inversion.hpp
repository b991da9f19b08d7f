// SPDX-License-Identifier: Apache-2.0
// How much a half-space must scatter to have a given colour: what random walks below a surface
// need.
#pragma once

#include "photon/exact_values.hpp"

namespace gonio {

/// Throws UsageError unless the layers are a half-space that can reflect each of these albedos:
/// from what its surface reflects alone (which it does with single-scattering albedo 0) to 1.
void check_inversion(const LightJob& light, const Axis& albedos);

/// The single-scattering albedo at which the half-space, with its index and its phase function,
/// reflects each of these parts of the light. Its reflectance is exact to the job's max_error,
/// 1e-6 if there is none; errors are those of the single-scattering albedo. `after_part` as in
/// exact_values(), by one thread after the other. Throws RunError where the max_error is out of
/// reach.
ExactValues invert_albedos(const LightJob& light, const Axis& albedos,
                           const reference::AfterPart& after_part);

}  // namespace gonio

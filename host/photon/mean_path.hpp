// SPDX-License-Identifier: Apache-2.0
// How far light that leaves has come in each layer.
#pragma once

#include "photon/exact_values.hpp"

namespace gonio {

/// Mean paths in cm, of diffusely reflected light in each layer and then of transmitted light. By
/// Beer and Lambert light that has come a path p through a layer carries a factor exp(-mua p), so
/// that the mean path is -d ln R / d mua: differentiated numerically, for adding-doubling has no
/// noise. 0 where no light leaves.
ExactValues mean_paths(const LightJob& light, const reference::AfterPart& after_part);

}  // namespace gonio

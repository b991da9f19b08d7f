// SPDX-License-Identifier: Apache-2.0
// Layers with values of sweeps.
#pragma once

#include <string>
#include <vector>

#include "gonio/layers.hpp"
#include "gonio/scene.hpp"

namespace gonio {

/// The medium where each sweep has its value of `point`. Throws UsageError, at the sweep's place,
/// as validate() does.
LayeredMedium swept_layers(LayeredMedium medium, const std::vector<Sweep>& sweeps,
                           const std::vector<double>& point);

/// "-mua=10" of one layer, "-layer_2.mua=10" of several: what tells files of sweeps apart.
std::string name_of_layers(const LayeredMedium& medium, const std::vector<Sweep>& sweeps,
                           const std::vector<double>& point);

}  // namespace gonio

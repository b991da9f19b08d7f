// SPDX-License-Identifier: Apache-2.0
// A tabulated phase function as the photon kernel draws from it.
#pragma once

#include <vector>

#include "gonio/layers.hpp"

namespace gonio {

/// Records of segment_field, one for each interval between two cosines of the table.
std::vector<float> phase_segments(const TabulatedPhase& phase);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Lobes of a scene's materials.
#pragma once

#include <vector>

#include "scene/reader.hpp"

namespace gonio {

/// `section` has a `model`, and may have a `weight` and `parameters`.
Lobe read_lobe(const Section& section, std::size_t part, std::vector<Sweep>& sweeps);

}  // namespace gonio

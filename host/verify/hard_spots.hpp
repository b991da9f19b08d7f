// SPDX-License-Identifier: Apache-2.0
// Where reflectance models are hardest to evaluate in float32.
#pragma once

#include <string>
#include <vector>

#include "gonio/grid.hpp"
#include "verify/textbook.hpp"

namespace gonio {

struct HardSpot {
    std::string name;
    Lobe lobe;
    std::vector<DirectionPair> pairs;
    textbook::Formula textbook;
};

/// The same every time.
std::vector<HardSpot> hard_spots();

}  // namespace gonio

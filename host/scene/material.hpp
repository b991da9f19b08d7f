// SPDX-License-Identifier: Apache-2.0
// Materials of a scene.
#pragma once

#include "scene/reader.hpp"

namespace gonio {

/// One [[material]].
SceneMaterial read_material(const Value& value);

/// Its layers and what lies around them.
LayeredMedium read_layers(const Section& material, std::vector<Sweep>& sweeps);

/// A name that can be the stem of a file.
std::string read_name(const Value& value);

}  // namespace gonio

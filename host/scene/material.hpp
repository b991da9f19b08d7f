// SPDX-License-Identifier: Apache-2.0
// Materials of a scene.
#pragma once

#include "scene/reader.hpp"

namespace gonio {

/// One [[material]].
SceneMaterial read_material(const Value& value);

/// The index of the material of that name.
std::size_t find_material(const Value& value, const std::vector<SceneMaterial>& materials);

/// Its layers and what lies around them.
LayeredMedium read_layers(const Section& material, std::vector<Sweep>& sweeps);

/// A model of skin with its parameters.
Skin read_skin(const Section& material, std::vector<Sweep>& sweeps);

/// The layers of skin at its `wavelength`.
LayeredMedium read_skin_layers(const Section& material);

/// A name that can be the stem of a file.
std::string read_name(const Value& value);

}  // namespace gonio

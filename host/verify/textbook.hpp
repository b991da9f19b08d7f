// SPDX-License-Identifier: Apache-2.0
// Models as textbooks write them, in float32 from unit vectors: what cancels and overflows in them
// shows what stability is worth. Nothing else uses them.
#pragma once

#include <glm/vec3.hpp>

#include "gonio/material.hpp"

namespace gonio::textbook {

/// f_r of a lobe in its first channel for unit vectors to light and viewer, or a value as its model
/// prints it.
using Formula = float (*)(const Lobe& lobe, glm::vec3 l, glm::vec3 v);

float ggx(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float beckmann(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float ward(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float phong(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float blinn_phong(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float ashikhmin_shirley(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float oren_nayar(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
/// torrance_sparrow with ndf = ggx and fresnel = conductor.
float ggx_conductor(const Lobe& lobe, glm::vec3 l, glm::vec3 v);
float beckmann_kirchhoff(const Lobe& lobe, glm::vec3 l, glm::vec3 v);

}  // namespace gonio::textbook

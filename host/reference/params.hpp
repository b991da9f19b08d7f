// SPDX-License-Identifier: Apache-2.0
// The parameter structs and signatures of all references, made from models.inc.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>

#include "gonio/material.hpp"

namespace gonio::reference {

using Color = std::array<double, max_channels>;

// enum class torrance_sparrow_ndf { ggx, ... };
#define CHOICE(id, name, preset, doc) \
    enum class id##_##name            \
    {
#define OPTION(id, name, option, traits, doc) option,
#define END_CHOICE(id, name) \
    }                        \
    ;
#include "gonio/shared/models.inc"

// struct ward_params { ... }; angles in radians.
#define MODEL(id, title, citation, traits) struct id##_params {
#define SCALAR(id, name, unit, least, greatest, preset, doc) double name;
#define COLOR(id, name, unit, least, greatest, preset, doc) Color name;
#define TABLE(id, name, doc) std::shared_ptr<const ResidualGrid> name;
#define CHOICE(id, name, preset, doc) id##_##name name;
#define END_MODEL(id) \
    }                 \
    ;
#include "gonio/shared/models.inc"

// double ward(const ward_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel);
// l, v: unit vectors to light and viewer in the frame where n is +z, l.z, v.z > 0. What the model
// prints, for one channel.
#define MODEL(id, title, citation, traits) \
    double id(const id##_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel);
#include "gonio/shared/models.inc"

// double he_torrance_specular(const he_torrance_params& p, glm::dvec3 l, std::size_t channel);
// The part of the light from l that is reflected in the mirror direction, by a Dirac.
#define SPECULAR(id) double id##_specular(const id##_params& p, glm::dvec3 l, std::size_t channel);
#include "gonio/shared/models.inc"

}  // namespace gonio::reference

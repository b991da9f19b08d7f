// SPDX-License-Identifier: Apache-2.0
// What of a scene's material a picture shows.
#pragma once

#include <vector>

#include "gonio/material.hpp"
#include "gonio/profile.hpp"
#include "gonio/scene.hpp"

namespace gonio {

struct PictureMaterial {
    Material surface;               ///< reflects at once; without lobes where indices match
    std::vector<ColourBand> bands;  ///< of the layers below it; empty without layers
};

/// What lights need of a material: lobes of weight 0 are left out, and layers where nothing
/// shines. The surface of layers for which a scene names none: facets (GGX, alpha 0.35) of the
/// first layer's refractive index, at 580 nm for skin. Throws UsageError, with its place, for a
/// material with sweeps.
PictureMaterial picture_material(const SceneMaterial& material, bool lit);

/// What making a picture takes, in samples.
double work_of(const PictureRequest& picture, const std::vector<SceneMaterial>& materials);

}  // namespace gonio

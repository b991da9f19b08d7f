// SPDX-License-Identifier: Apache-2.0
// What the layers of skin return, as pictures need it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/material.hpp"
#include "gonio/skin.hpp"

namespace gonio {

/// The surface of skin if a scene names no other: facets (GGX, alpha 0.35) of its first layer's
/// refractive index at 580 nm.
Lobe skin_surface(const Skin& skin);

/// The part of the light from a direction that the layers return, without what the surface
/// reflects: rho(mu), linear sRGB under D65, from adding-doubling at every 20 nm. The layers are
/// solved below a smooth surface, whose Fresnel reflectance is then replaced by the albedo of
/// `surface`, so that what it reflects does not enter. The BRDF of the layers is taken as
/// rho(mu_i) rho(mu_o)/(pi mean): reciprocal, and right in energy for every direction of light.
class SkinReflectance {
public:
    SkinReflectance(const Device& device, const Skin& skin, const Material& surface);

    glm::dvec3 at(double cosine) const;
    glm::dvec3 mean() const { return mean_; }  ///< in uniform light

private:
    std::vector<glm::dvec3> nodes_;  ///< at even steps of the cosine's root
    glm::dvec3 mean_{0};
};

}  // namespace gonio

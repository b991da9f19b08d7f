// SPDX-License-Identifier: Apache-2.0
// What layers return, as pictures need it.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/profile.hpp"
#include "picture/surface_albedo.hpp"

namespace gonio {

/// The part of the light from a direction that layers return, without what the surface reflects:
/// rho(mu), linear sRGB, from adding-doubling in each band. The layers are solved below a smooth
/// surface, whose Fresnel reflectance is then replaced by the albedo of `surface`, so that what it
/// reflects does not enter. The BRDF of the layers is taken as rho(mu_i) rho(mu_o)/(pi mean):
/// reciprocal, and right in energy for every direction of light.
class LayerReflectance {
public:
    static constexpr std::size_t angles = 25;  ///< that are solved, in each band

    /// `after_each` is called after each band, by several threads; what it throws ends the work.
    LayerReflectance(
        const Device& device, const std::vector<ColourBand>& bands, const Material& surface,
        const std::function<void()>& after_each = [] {});

    glm::dvec3 at(double cosine) const;
    glm::dvec3 mean() const { return mean_; }  ///< in uniform light

private:
    SurfaceAlbedo surface_;
    std::vector<glm::dvec3> nodes_;  ///< of what has entered, at even steps of the cosine's root
    glm::dvec3 mean_{0};
};

}  // namespace gonio

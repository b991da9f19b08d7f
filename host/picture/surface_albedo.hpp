// SPDX-License-Identifier: Apache-2.0
// What a surface in a picture reflects of uniform light.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/material.hpp"

namespace gonio {

/// Directional albedos of a viewer, linear sRGB, between those of a table: 64 cosines and, of
/// brushed materials, 24 azimuths. They are exact to 1e-5 in the table and to 1e-3 between.
class SurfaceAlbedo {
public:
    static constexpr std::size_t cosines = 64;

    /// Without lobes all of it is 0.
    SurfaceAlbedo(const Device& device, const Material& surface);

    /// phi: degrees.
    glm::dvec3 at(double cosine, double phi) const;

private:
    std::size_t azimuths_ = 1;
    std::vector<glm::dvec3> values_;  ///< [azimuth][cosine]
};

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Directional albedos by deterministic quadrature on a device.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/material.hpp"

namespace gonio {

/// A direction: cosine to the normal, in (0, 1], and azimuth in degrees.
struct Incidence {
    double cosine = 1, phi = 0;
};

/// In the frame where n is +z and the tangent +x.
glm::dvec3 unit_vector(const Incidence& at);

/// What is integrated: f cos theta_o over all viewers for a light at the direction, or f cos
/// theta_i over all lights for a viewer there. They differ where a BRDF is not reciprocal.
enum class Fixed { light, viewer };

/// One integral: which of the materials, and where.
struct AlbedoCell {
    std::size_t material = 0;
    Incidence at;
};

struct AlbedoOptions {
    Fixed fixed = Fixed::light;
    double max_error = 1e-6;  ///< of an albedo up to 1, absolute; relative above
    /// No order is begun with which all would take longer than this, s, as the lower ones tell; the
    /// lowest two always are. Building programs is not counted.
    double seconds = std::numeric_limits<double>::infinity();
};

/// value[channel][cell], and bounds of the errors: what two orders differ by, and what float32
/// leaves. An error above max_error is one that the highest order did not reach.
struct Albedos {
    std::vector<std::vector<double>> value, error;
    int order = 0;              ///< the highest that a cell needed
    std::size_t evaluated = 0;  ///< evaluations of the BRDF
    double kernel_seconds = 0;
};

/// materials: the same lobes and options in each, with different numbers. Cells in ascending order
/// of their materials.
Albedos integrate_albedos(const Device& device, const std::vector<Material>& materials,
                          const std::vector<AlbedoCell>& cells, const AlbedoOptions& options = {});

}  // namespace gonio

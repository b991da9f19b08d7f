// SPDX-License-Identifier: Apache-2.0
// Importance sampling on a device: random viewers for a fixed light, as dense as the material's own
// lobes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "gonio/albedo.hpp"
#include "gonio/device.hpp"
#include "gonio/material.hpp"

namespace gonio {

/// Samples first to first + count - 1 of a seed. Each depends on nothing else: not on the device's
/// vector width, nor on how many are drawn at once.
struct SampleRange {
    std::uint64_t seed = 1;
    std::uint64_t first = 0;
    std::size_t count = 1000;
};

struct ViewerSamples {
    /// To the viewer, in the frame where n is +z. z <= 0: below the horizon, where pdf and weight
    /// are 0.
    std::vector<glm::vec3> viewer;
    std::vector<float> pdf;  ///< per solid angle of viewers, in 1/sr
    /// [channel][sample]: f cos theta_o/pdf, whose mean is the directional albedo.
    std::vector<std::vector<float>> weight;
};

/// Throws UsageError, with the names of those that can be, where a model cannot be sampled. Lobes
/// are sampled as often as each other, whatever their weights.
ViewerSamples sample_viewers(const Device& device, const Material& material, const Incidence& light,
                             const SampleRange& range);

/// The density of such samples at given viewers, unit vectors; 0 below the horizon. Its integral is
/// 1 less the probability of a sample below the horizon.
std::vector<float> sampling_density(const Device& device, const Material& material,
                                    const Incidence& light, const std::vector<glm::dvec3>& viewers);

}  // namespace gonio

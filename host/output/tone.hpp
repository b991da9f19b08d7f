// SPDX-License-Identifier: Apache-2.0
// From what a device gives to what a screen shows.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace gonio {

/// values[channel][k] as linear sRGB (IEC 61966-2-1): the first three channels, or the first one as
/// grey.
std::vector<glm::vec3> as_rgb(const std::vector<std::vector<float>>& values);

/// One number for each channel, or one for all, likewise; black if there are none.
glm::vec3 rgb_of(const std::vector<double>& numbers);

float greatest(glm::vec3 colour);

/// What to multiply radiance with before it is shown, so that its bright parts come out bright and
/// small highlights white.
float exposure_of(std::span<const glm::vec3> radiance);

/// Exposed linear radiance to encoded sRGB, 0 to 1: linear up to a half, then an exponential
/// shoulder in each channel, so that highlights lose their colour as on film.
glm::vec3 to_screen(glm::vec3 exposed);

/// The transfer function of IEC 61966-2-1: linear 0 to 1 to encoded 0 to 1.
float encode(float linear);

}  // namespace gonio

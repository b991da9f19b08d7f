// SPDX-License-Identifier: Apache-2.0
// Exposure, tone mapping and the encoding of sRGB.
#include "output/tone.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {

std::vector<glm::vec3> as_rgb(const std::vector<std::vector<float>>& values)
{
    const bool rgb = values.size() >= 3;
    const auto &red = values[0], &green = values[rgb ? 1 : 0], &blue = values[rgb ? 2 : 0];
    std::vector<glm::vec3> colours;
    colours.reserve(red.size());
    for (std::size_t k = 0; k < red.size(); ++k) colours.emplace_back(red[k], green[k], blue[k]);
    return colours;
}

glm::vec3 rgb_of(const std::vector<double>& numbers)
{
    if (numbers.empty()) return glm::vec3(0);
    std::vector<std::vector<float>> planes;
    for (const double number : numbers) planes.push_back({static_cast<float>(number)});
    return as_rgb(planes).front();
}

float greatest(glm::vec3 colour)
{
    return std::max({colour.x, colour.y, colour.z});
}

float exposure_of(std::span<const glm::vec3> radiance)
{
    std::vector<float> lit;
    for (const glm::vec3 value : radiance)
        if (const float most = greatest(value); most > 0) lit.push_back(most);
    if (lit.empty()) return 1;
    std::ranges::sort(lit);
    // A highlight that is brighter than this is too small to be exposed for, but the falling
    // tail of a lone one must not be taken for a surface.
    return 0.75f / std::max(lit[lit.size() * 24 / 25], lit.back() / 50);
}

glm::vec3 to_screen(glm::vec3 exposed)
{
    constexpr float knee = 0.5f;
    const auto shown = [](float x) {
        return encode(x < knee ? x : 1 - (1 - knee) * std::exp((knee - x) / (1 - knee)));
    };
    return {shown(exposed.x), shown(exposed.y), shown(exposed.z)};
}

float encode(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The usual bake of a split sum, on all cores.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "quadrature/hammersley.hpp"

namespace gonio::bench {
namespace {

/// Van der Corput's sequence in base 2.
float radical_inverse(std::uint32_t k)
{
    k = (k << 16) | (k >> 16);
    k = ((k & 0x55555555U) << 1) | ((k & 0xaaaaaaaaU) >> 1);
    k = ((k & 0x33333333U) << 2) | ((k & 0xccccccccU) >> 2);
    k = ((k & 0x0f0f0f0fU) << 4) | ((k & 0xf0f0f0f0U) >> 4);
    k = ((k & 0x00ff00ffU) << 8) | ((k & 0xff00ff00U) >> 8);
    return static_cast<float>(k) * 2.3283064365386963e-10F;
}

struct Sums {
    float scale, bias;
};

Sums cell(float alpha, float mu, const std::vector<float>& cosines, const std::vector<float>& us)
{
    const float sine = std::sqrt(1 - mu * mu), a2 = alpha * alpha;
    Sums sums{0, 0};
    for (std::size_t k = 0; k < us.size(); ++k) {
        const float cos_h = std::sqrt((1 - us[k]) / (1 + (a2 - 1) * us[k]));
        const float sin_h = std::sqrt(1 - cos_h * cos_h);
        const float v_h = sine * sin_h * cosines[k] + mu * cos_h;
        const float l_n = 2 * v_h * cos_h - mu;
        if (l_n <= 0 || v_h <= 0) continue;
        const float visibility = 0.5F / (l_n * std::sqrt(a2 + (1 - a2) * mu * mu) +
                                         mu * std::sqrt(a2 + (1 - a2) * l_n * l_n));
        const float weight = visibility * 4 * l_n * v_h / cos_h;
        const float rest = 1 - v_h, rest2 = rest * rest, fresnel = rest2 * rest2 * rest;
        sums.scale += (1 - fresnel) * weight;
        sums.bias += fresnel * weight;
    }
    return {sums.scale / static_cast<float>(us.size()), sums.bias / static_cast<float>(us.size())};
}

}  // namespace

void hammersley_split_sum(float* scale, float* bias, std::size_t size, unsigned samples)
{
    std::vector<float> cosines, us;
    for (unsigned k = 0; k < samples; ++k) {
        const float turn = static_cast<float>(k) / static_cast<float>(samples);
        cosines.push_back(std::cos(2 * std::numbers::pi_v<float> * turn));
        us.push_back(radical_inverse(k));
    }
#pragma omp parallel for schedule(dynamic)
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column < size; ++column) {
            const float roughness = (static_cast<float>(row) + 0.5F) / static_cast<float>(size);
            const float mu = (static_cast<float>(column) + 0.5F) / static_cast<float>(size);
            const Sums sums = cell(roughness * roughness, mu, cosines, us);
            scale[row * size + column] = sums.scale;
            bias[row * size + column] = sums.bias;
        }
}

}  // namespace gonio::bench

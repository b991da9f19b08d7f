// SPDX-License-Identifier: Apache-2.0
// The usual bake of a split sum, on all processors.
#include "timings/sampled_split_sum.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "parallel.hpp"

namespace gonio {
namespace {

/// Van der Corput's sequence in base 2.
float radical_inverse(std::uint32_t k)
{
    k = (k << 16) | (k >> 16);
    k = ((k & 0x55555555U) << 1) | ((k & 0xaaaaaaaaU) >> 1);
    k = ((k & 0x33333333U) << 2) | ((k & 0xccccccccU) >> 2);
    k = ((k & 0x0f0f0f0fU) << 4) | ((k & 0xf0f0f0f0U) >> 4);
    k = ((k & 0x00ff00ffU) << 8) | ((k & 0xff00ff00U) >> 8);
    return static_cast<float>(k) * 0x1p-32F;
}

/// Points of the unit square, the azimuths as their cosines.
struct Points {
    std::vector<float> cosines, us;

    Points(unsigned samples, SampleSet set)
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> even(0, 1);
        for (unsigned k = 0; k < samples; ++k) {
            const bool is_random = set == SampleSet::random;
            const float turn =
                is_random ? even(random) : static_cast<float>(k) / static_cast<float>(samples);
            cosines.push_back(std::cos(2 * std::numbers::pi_v<float> * turn));
            us.push_back(is_random ? even(random) : radical_inverse(k));
        }
    }
};

struct Sums {
    float scale = 0, bias = 0;
};

Sums cell(float alpha, float mu, const Points& points)
{
    const float sine = std::sqrt(1 - mu * mu), a2 = alpha * alpha;
    Sums sums;
    for (std::size_t k = 0; k < points.us.size(); ++k) {
        const float u = points.us[k];
        const float cos_h = std::sqrt((1 - u) / (1 + (a2 - 1) * u));
        const float sin_h = std::sqrt(1 - cos_h * cos_h);
        const float v_h = sine * sin_h * points.cosines[k] + mu * cos_h;
        const float l_n = 2 * v_h * cos_h - mu;
        if (l_n <= 0 || v_h <= 0) continue;
        const float visibility = 0.5F / (l_n * std::sqrt(a2 + (1 - a2) * mu * mu) +
                                         mu * std::sqrt(a2 + (1 - a2) * l_n * l_n));
        const float weight = visibility * 4 * l_n * v_h / cos_h;
        const float rest = 1 - v_h, rest2 = rest * rest, fresnel = rest2 * rest2 * rest;
        sums.scale += (1 - fresnel) * weight;
        sums.bias += fresnel * weight;
    }
    const auto samples = static_cast<float>(points.us.size());
    return {sums.scale / samples, sums.bias / samples};
}

}  // namespace

SampledSplitSum sampled_split_sum(std::size_t size, unsigned samples, SampleSet set)
{
    const Points points(samples, set);
    SampledSplitSum table{std::vector<float>(size * size), std::vector<float>(size * size)};
    in_parallel(size, [&](std::size_t row) {
        const auto middle = [&](std::size_t k) {
            return (static_cast<float>(k) + 0.5F) / static_cast<float>(size);
        };
        for (std::size_t column = 0; column < size; ++column) {
            const Sums sums = cell(middle(row) * middle(row), middle(column), points);
            table.scale[row * size + column] = sums.scale;
            table.bias[row * size + column] = sums.bias;
        }
    });
    return table;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Blocks of pixels as coarse as a Gaussian allows, and the sum over Gaussians.
#include "picture/spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "gonio/shared/spread_fields.h"
#include "opencl/spread_kernel.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr double reach = 3;          // standard deviations
constexpr double blocks_across = 2;  // at least, of a standard deviation
constexpr unsigned widest_stride = 256;

/// The side of a pixel that is seen face to face, mm: what a tenth of them do not exceed.
double pixel_side(const EnteringLight& entering)
{
    std::vector<double> areas;
    for (const double area : entering.area)
        if (area > 0) areas.push_back(area);
    if (areas.empty()) return 0;
    const auto tenth = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 10);
    std::ranges::nth_element(areas, tenth);
    return std::sqrt(*tenth);
}

SpreadBlocks blocks_of(const EnteringLight& entering, unsigned stride)
{
    const auto blocks_along = [&](std::size_t pixels) {
        return static_cast<unsigned>((pixels + stride - 1) / stride);
    };
    SpreadBlocks blocks{stride, blocks_along(entering.width), blocks_along(entering.height), {}};
    std::vector<std::array<double, block_fields>> sums(std::size_t{blocks.columns} * blocks.rows);
    for (std::size_t k = 0; k < entering.area.size(); ++k) {
        auto& sum =
            sums[k / entering.width / stride * blocks.columns + k % entering.width / stride];
        const double area = entering.area[k];
        for (int c = 0; c < 3; ++c) {
            sum[static_cast<std::size_t>(block_x + c)] += area * entering.place[k][c];
            sum[static_cast<std::size_t>(block_red + c)] += area * entering.light[k][c];
        }
        sum[block_area] += area;
    }
    for (auto& sum : sums) {
        for (const block_field place : {block_x, block_y, block_z})
            if (sum[block_area] > 0) sum[place] /= sum[block_area];
        for (const double number : sum) blocks.values.push_back(static_cast<float>(number));
    }
    return blocks;
}

std::vector<float> places_of(const EnteringLight& entering)
{
    const std::size_t plane = entering.area.size();
    std::vector<float> places(place_planes * plane);
    for (std::size_t k = 0; k < plane; ++k) {
        for (int c = 0; c < 3; ++c)
            places[(place_x + static_cast<std::size_t>(c)) * plane + k] =
                static_cast<float>(entering.place[k][c]);
        places[place_column * plane + k] =
            entering.area[k] > 0 ? static_cast<float>(k % entering.width) : -1;
    }
    return places;
}

}  // namespace

std::vector<dvec3> spread_light(const Device& device, const EnteringLight& entering,
                                const SumOfGaussians& profile,
                                const std::function<void(double part)>& after_each)
{
    std::vector<dvec3> result(entering.area.size());
    const double side = pixel_side(entering);
    if (side == 0) return result;
    dvec3 total(0);
    for (const auto& weights : profile.weights) total += dvec3(weights[0], weights[1], weights[2]);
    SpreadKernel kernel(device, entering.width, entering.height, places_of(entering));
    SpreadBlocks blocks;
    for (std::size_t g = 0; g < profile.variances.size(); ++g) {
        const double deviation = std::sqrt(profile.variances[g]);
        unsigned stride = 1;
        while (stride < widest_stride && 2 * stride * side * blocks_across <= deviation)
            stride *= 2;
        if (blocks.stride != stride || blocks.values.empty()) blocks = blocks_of(entering, stride);
        const auto radius = static_cast<unsigned>(std::ceil(reach * deviation / (stride * side)));
        const std::vector<float> light = kernel.spread(
            blocks, profile.variances[g], std::min(radius, blocks.columns + blocks.rows));
        const std::size_t plane = result.size();
        for (int c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            if (profile.weights[g][channel] == 0) continue;
            const double weight = profile.weights[g][channel] / total[c];
            for (std::size_t k = 0; k < plane; ++k)
                result[k][c] += weight * static_cast<double>(light[channel * plane + k]);
        }
        after_each(1 / static_cast<double>(profile.variances.size()));
    }
    return result;
}

}  // namespace gonio

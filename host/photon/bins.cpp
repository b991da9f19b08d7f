// SPDX-License-Identifier: Apache-2.0
// Which tallies a quantity needs, and what its bins are divided by.
#include "photon/bins.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace gonio {
namespace {

using std::numbers::pi;

const std::vector<Fraction>& tally(const PhotonResult& result, const PhotonTallies& tallies)
{
    if (tallies.absorbed) return result.absorbed;
    return tallies.reflected ? result.reflected : result.transmitted;
}

std::vector<Fraction> budget(const PhotonResult& result)
{
    std::vector<Fraction> parts = {result.specular, result.diffuse_reflectance,
                                   result.unscattered_transmittance, result.diffuse_transmittance,
                                   result.bottom_absorption};
    parts.insert(parts.end(), result.absorption.begin(), result.absorption.end());
    return parts;
}

}  // namespace

double solid_angle(std::size_t k, std::size_t n)
{
    // 2 pi (cos a - cos b) without the difference
    const double width = pi / 2 / static_cast<double>(n);
    return 4 * pi * std::sin((static_cast<double>(k) + 0.5) * width) * std::sin(width / 2);
}

double ring_area(std::size_t k, double width)
{
    return (2 * static_cast<double>(k) + 1) * pi * width * width;
}

PhotonTallies tallies_of(const Quantity& quantity, const std::vector<Axis>& axes)
{
    PhotonTallies tallies;
    tallies.reflected = quantity.id.starts_with("reflectance");
    tallies.transmitted = quantity.id.starts_with("transmittance");
    tallies.absorbed = quantity.id.starts_with("absorption");
    for (const Axis& axis : axes) {
        const std::size_t count = axis.values.size();
        const double width = 2 * axis.values.front();
        if (axis.name == "alpha") {
            tallies.angles = count;
        } else if (axis.name == "z") {
            tallies.depths = count;
            tallies.depth_width = width;
        } else {
            (tallies.absorbed ? tallies.absorbed_radii : tallies.radii) = count;
            tallies.radius_width = width;
        }
    }
    return tallies;
}

std::vector<Fraction> densities(const PhotonResult& result, const Quantity& quantity,
                                const PhotonTallies& tallies)
{
    if (quantity.axes.empty()) return budget(result);
    const std::size_t rows = tallies.absorbed ? tallies.depths : tallies.radii;
    const std::size_t columns = tallies.absorbed ? tallies.absorbed_radii : tallies.angles;
    const std::size_t stride = tallies.absorbed ? columns + 1 : columns;
    const auto size = [&](std::size_t row, std::size_t column) {
        if (tallies.absorbed)
            return tallies.depth_width *
                   (columns == 0 ? 1 : ring_area(column, tallies.radius_width));
        return (rows == 0 ? 1 : ring_area(row, tallies.radius_width)) *
               (columns == 1 ? 1 : solid_angle(column, columns));
    };
    std::vector<Fraction> all;
    // Without bins of one kind, what is there is in the overflow's place.
    for (std::size_t row = 0; row < std::max<std::size_t>(rows, 1); ++row)
        for (std::size_t column = 0; column < std::max<std::size_t>(columns, 1); ++column) {
            const Fraction& bin = tally(result, tallies)[row * stride + column];
            all.push_back({bin.mean / size(row, column), bin.error / size(row, column)});
        }
    return all;
}

std::uint64_t batch_of(std::uint64_t photons)
{
    constexpr std::uint64_t batches = 64;
    return std::bit_floor(std::clamp<std::uint64_t>(photons / batches, 2, 1 << 30));
}

double overflow(const PhotonResult& result, const PhotonTallies& tallies)
{
    double beyond = 0;
    const auto& bins = tally(result, tallies);
    for (std::size_t k = 0; k < bins.size(); ++k) {
        const std::size_t stride = tallies.absorbed ? tallies.absorbed_radii + 1 : tallies.angles;
        const std::size_t row = k / stride, column = k % stride;
        const bool deep =
            tallies.absorbed ? row == tallies.depths : tallies.radii > 0 && row == tallies.radii;
        const bool far =
            tallies.absorbed && tallies.absorbed_radii > 0 && column == tallies.absorbed_radii;
        if (deep || far) beyond += bins[k].mean;
    }
    return beyond;
}

}  // namespace gonio

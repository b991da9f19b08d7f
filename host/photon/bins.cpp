// SPDX-License-Identifier: Apache-2.0
// Which tallies a quantity needs, and what its bins are divided by.
#include "photon/bins.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "grid/azimuths.hpp"
#include "photon/exact_values.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

const std::vector<Fraction>& tally(const PhotonResult& result, const PhotonTallies& tallies)
{
    if (tallies.absorbed) return result.absorbed;
    return tallies.reflected ? result.reflected : result.transmitted;
}

/// Both sides of the plane of incidence share their rows.
std::size_t azimuth_rows(const Axis& delta_phi)
{
    const std::size_t cells = delta_phi.values.size();
    return covers_whole_turn(delta_phi) ? cells / 2 : cells;
}

/// f_r in cells (theta_o, delta_phi): the light in a bin over the integral of cos theta_o there.
/// Rows begin where the beam goes, delta_phi where it comes from.
std::vector<Fraction> reflectances(const PhotonResult& result, const PhotonTallies& tallies,
                                   const std::vector<Axis>& axes)
{
    const double width = pi / 2 / static_cast<double>(tallies.angles);
    std::vector<Fraction> all;
    for (std::size_t angle = 0; angle < tallies.angles; ++angle)
        for (std::size_t cell = 0; cell < axes[2].values.size(); ++cell) {
            const std::size_t row =
                cell < tallies.rows ? tallies.rows - 1 - cell : cell - tallies.rows;
            const double cosines = pi / static_cast<double>(tallies.rows) *
                                   std::sin((2 * static_cast<double>(angle) + 1) * width) *
                                   std::sin(width);
            const Fraction& bin = result.reflected[row * tallies.angles + angle];
            all.push_back({bin.mean / cosines, bin.error / cosines});
        }
    return all;
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
    if (quantity.on_grid()) {
        tallies.reflected = true;
        tallies.row = ExitRow::azimuth;
        tallies.rows = azimuth_rows(axes[2]);
        tallies.angles = axes[1].values.size();
        return tallies;
    }
    for (const Axis& axis : axes) {
        const std::size_t count = axis.values.size();
        const double width = 2 * axis.values.front();
        if (axis.name == "alpha") {
            tallies.angles = count;
        } else if (axis.name == "t") {
            tallies.row = ExitRow::time;
            tallies.rows = count;
            tallies.time_width = width;
        } else if (axis.name == "z") {
            tallies.depths = count;
            tallies.depth_width = width;
        } else {
            (tallies.absorbed ? tallies.absorbed_radii : tallies.rows) = count;
            tallies.radius_width = width;
        }
    }
    return tallies;
}

std::vector<Fraction> densities(const PhotonResult& result, const Quantity& quantity,
                                const PhotonTallies& tallies, const std::vector<Axis>& axes)
{
    if (quantity.axes.empty()) return parts_of(result);
    if (quantity.on_grid()) return reflectances(result, tallies, axes);
    const std::size_t rows = tallies.absorbed ? tallies.depths : tallies.rows;
    const std::size_t columns = tallies.absorbed ? tallies.absorbed_radii : tallies.angles;
    const std::size_t stride = tallies.absorbed ? columns + 1 : columns;
    const auto size = [&](std::size_t row, std::size_t column) {
        if (tallies.absorbed)
            return tallies.depth_width *
                   (columns == 0 ? 1 : ring_area(column, tallies.radius_width));
        if (tallies.row == ExitRow::time) return tallies.time_width;
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

std::vector<Fraction> ring_densities(const std::vector<Fraction>& rings, double width)
{
    std::vector<Fraction> all;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const double area = ring_area(k, width);
        all.push_back({rings[k].mean / area, rings[k].error / area});
    }
    return all;
}

double largest_error(const std::vector<Fraction>& values)
{
    double value = 0, error = 0;
    for (const Fraction& one : values) {
        value = std::max(value, one.mean);
        error = std::max(error, one.error);
    }
    return value > 0 ? error / value : 0;
}

double mean_relative_error(const std::vector<Fraction>& values)
{
    double sum = 0;
    for (const Fraction& one : values)
        sum += one.mean == 0 ? INFINITY : std::pow(one.error / one.mean, 2);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

std::uint64_t batch_of(std::uint64_t photons)
{
    constexpr std::uint64_t batches = 64;
    return std::bit_floor(std::clamp<std::uint64_t>(photons / batches, 2, 1 << 30));
}

std::uint64_t batch_from(std::uint64_t photon, std::uint64_t most)
{
    constexpr std::uint64_t least_batch = 1024;
    if (most != no_limit) return batch_of(most);
    return std::clamp(std::bit_floor(photon / least_batches), least_batch, largest_batch);
}

double overflow(const PhotonResult& result, const PhotonTallies& tallies)
{
    double beyond = 0;
    const auto& bins = tally(result, tallies);
    for (std::size_t k = 0; k < bins.size(); ++k) {
        const std::size_t stride = tallies.absorbed ? tallies.absorbed_radii + 1 : tallies.angles;
        const std::size_t row = k / stride, column = k % stride;
        const bool deep =
            tallies.absorbed ? row == tallies.depths : tallies.rows > 0 && row == tallies.rows;
        const bool far =
            tallies.absorbed && tallies.absorbed_radii > 0 && column == tallies.absorbed_radii;
        if (deep || far) beyond += bins[k].mean;
    }
    return beyond;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The half-plane by each ring's part on the lit side; the BRDF by adding-doubling.
#include "verify/picture_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/spread.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/layered_brdf.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

constexpr std::size_t columns = 160, rows = 120;
constexpr double side = 0.2;      // of a pixel, mm
constexpr std::size_t near = 40;  // pixels from the edge

/// A plane seen face to face, lit in its right half.
EnteringLight half_lit_plane()
{
    EnteringLight seen{columns, rows, {}, {}, std::vector<double>(columns * rows, side * side)};
    for (std::size_t k = 0; k < columns * rows; ++k) {
        const std::size_t column = k % columns, row = k / columns;
        seen.place.emplace_back(side * static_cast<double>(column), side * static_cast<double>(row),
                                0);
        seen.light.emplace_back(column >= columns / 2 ? 1 : 0);
    }
    return seen;
}

/// At `x` mm from the edge, positive on the lit side.
double behind_an_edge(const RadialProfile& profile, std::size_t channel, double x)
{
    double lit = x > 0 ? profile.total[channel].mean : 0;  // what lies beyond the rings is little
    for (std::size_t k = 0; k < profile.rings[channel].size(); ++k) {
        const double r = 10 * profile.width * (static_cast<double>(k) + 0.5);  // mm
        if (r > std::abs(x))
            lit +=
                profile.rings[channel][k].mean * std::acos(std::abs(x) / r) / pi * (x > 0 ? -1 : 1);
    }
    return lit / profile.total[channel].mean;
}

}  // namespace

double error_behind_an_edge(const Device& device, const SumOfGaussians& gaussians,
                            const RadialProfile& photons)
{
    const auto light = spread_light(device, half_lit_plane(), gaussians);
    double worst = 0;
    for (std::size_t x = columns / 2 - near; x < columns / 2 + near; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
            const double from_edge = side * (static_cast<double>(x) - columns / 2.0 + 0.5);
            worst = std::max(worst, std::abs(light[rows / 2 * columns + x][static_cast<int>(c)] -
                                             behind_an_edge(photons, c, from_edge)));
        }
    return worst;
}

double error_of_separable_shape(const LayeredMedium& layers)
{
    const std::vector<double> theta{0.0, pi / 6, pi / 3}, azimuth{0, pi / 2, pi};
    const auto brdf = reference::layered_brdf_to(layers, theta, theta, azimuth, 1e-3);
    const auto solution = reference::solve_layers_to(layers, {.incidence = theta}, 1e-4);
    const auto rho = [&](std::size_t k) {
        return solution.collimated[k].budget.diffuse_reflectance;
    };
    double worst = 0;
    auto value = brdf.values.begin();
    for (std::size_t i = 0; i < theta.size(); ++i)
        for (std::size_t o = 0; o < theta.size(); ++o)
            for (std::size_t a = 0; a < azimuth.size(); ++a) {
                const double separable =
                    rho(i) * rho(o) / (pi * solution.diffuse.budget.diffuse_reflectance);
                worst = std::max(worst, std::abs(separable / *value++ - 1));
            }
    return worst;
}

}  // namespace gonio

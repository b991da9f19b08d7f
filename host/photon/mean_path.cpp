// SPDX-License-Identifier: Apache-2.0
// Derivatives of reflectance and transmittance by absorption.
#include "photon/mean_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/adding_doubling.hpp"

namespace gonio {
namespace {

/// ln of what leaves upwards, without what is specular, and of what leaves downwards.
using Logarithms = std::array<double, 2>;

Logarithms leaving(const LightJob& light, std::size_t layer, double added, int nodes)
{
    LayeredMedium medium = light.medium;
    medium.layers[layer].mua += added;
    const auto solution =
        reference::solve_layers(medium, {.incidence = {light.light.incidence}}, nodes);
    const auto& budget = solution.under(light.light).budget;
    return {std::log(budget.diffuse_reflectance),
            std::log(budget.unscattered_transmittance + budget.diffuse_transmittance)};
}

/// Minus the derivative of the values at 0, h, 2h, 3h, 4h with an error of the fourth order:
/// absorption is never negative.
double falling(const std::array<Logarithms, 5>& at, std::size_t side, double h)
{
    return (25 * at[0][side] - 48 * at[1][side] + 36 * at[2][side] - 16 * at[3][side] +
            3 * at[4][side]) /
           (12 * h);
}

struct Path {
    double mean = 0, error = INFINITY;
};

/// Of light upwards and downwards.
std::array<Path, 2> paths(const LightJob& light, std::size_t layer, int nodes)
{
    constexpr double enough = 1e-6;
    constexpr int most = 6;
    const Layer& one = light.medium.layers[layer];
    const Logarithms here = leaving(light, layer, 0, nodes);
    const double rough_step = 1e-6 * (one.mua + one.mus + 1 / one.d + 1e-3);
    const Logarithms beyond = leaving(light, layer, rough_step, nodes);
    std::array<Path, 2> result;
    double longest = 0;
    for (const std::size_t side : {0U, 1U}) {
        const double rough = (here[side] - beyond[side]) / rough_step;
        if (rough > 0 && std::isfinite(rough))
            longest = std::max(longest, rough);
        else
            result[side] = {0, 0};
    }
    if (longest == 0) return result;
    // From steps that weaken light by a few per cent to shorter ones, until two of them agree: the
    // few photons that come far through a deep layer need short ones.
    std::array<Logarithms, 5> at{here};
    std::array<double, 2> before = {INFINITY, INFINITY};
    double h = 0.02 / longest;
    for (int round = 0; round < most; ++round, h /= 4) {
        for (std::size_t k = 1; k < at.size(); ++k)
            at[k] = leaving(light, layer, static_cast<double>(k) * h, nodes);
        bool agree = true;
        for (const std::size_t side : {0U, 1U}) {
            if (result[side].error == 0) continue;
            const double found = falling(at, side, h), error = std::abs(found - before[side]);
            if (error < result[side].error) result[side] = {found, error};
            before[side] = found;
            agree = agree && result[side].error <= enough * result[side].mean;
        }
        if (agree) break;
    }
    return result;
}

}  // namespace

ExactValues mean_paths(const LightJob& light, const reference::AfterPart& after_part)
{
    // Errors of the quadrature cancel in differences: nodes for the budgets are enough.
    constexpr double budget_error = 1e-6;
    const int nodes = reference::solve_layers_to(
                          light.medium, {.incidence = {light.light.incidence}}, budget_error)
                          .nodes;
    const std::size_t layers = light.medium.layers.size();
    ExactValues result{std::vector<Fraction>(2 * layers), nodes};
    for (std::size_t layer = 0; layer < layers; ++layer) {
        const auto fine = paths(light, layer, nodes);
        after_part((static_cast<double>(layer) + 2.0 / 3) / static_cast<double>(layers));
        const auto coarse = paths(light, layer, nodes * 7 / 10);
        after_part((static_cast<double>(layer) + 1) / static_cast<double>(layers));
        for (const std::size_t side : {0U, 1U})
            result.values[side * layers + layer] = {
                fine[side].mean,
                std::max(fine[side].error, std::abs(fine[side].mean - coarse[side].mean))};
    }
    for (const Fraction& path : result.values)
        if (path.mean > 0) result.error = std::max(result.error, path.error / path.mean);
    return result;
}

}  // namespace gonio

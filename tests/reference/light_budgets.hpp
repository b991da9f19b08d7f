// SPDX-License-Identifier: Apache-2.0
// What tests of several solvers ask of exact budgets of light.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "reference/adding_doubling.hpp"
#include "reference/gauss_legendre.hpp"

namespace gonio::test {

inline double reflectance(const reference::LightBudget& budget)
{
    return budget.specular + budget.diffuse_reflectance;
}

inline double transmittance(const reference::LightBudget& budget)
{
    return budget.unscattered_transmittance + budget.diffuse_transmittance;
}

/// Calls add(name, measured, exact) for each part of a measured budget.
template <class Measured, class Add>
void for_each_part(const Measured& measured, const reference::LightBudget& exact, const Add& add)
{
    add("specular", measured.specular, exact.specular);
    add("diffuse reflectance", measured.diffuse_reflectance, exact.diffuse_reflectance);
    add("unscattered transmittance", measured.unscattered_transmittance,
        exact.unscattered_transmittance);
    add("diffuse transmittance", measured.diffuse_transmittance, exact.diffuse_transmittance);
    add("bottom", measured.bottom_absorption, exact.bottom_absorption);
    for (std::size_t i = 0; i < exact.absorption.size(); ++i)
        add("layer " + std::to_string(i + 1), measured.absorption[i], exact.absorption[i]);
}

/// Scattered light of normal incidence in equal bins of the exit angle.
struct AngularBins {
    reference::LightBudget budget;
    std::vector<double> reflected, transmitted;
};

/// The mean over a bin by three Gauss-Legendre points.
inline AngularBins exact_angular_bins(const LayeredMedium& medium, std::size_t bins)
{
    const reference::QuadratureRule rule = reference::gauss_legendre(3);
    const double width = std::numbers::pi / 2 / static_cast<double>(bins);
    reference::LightRequest angles{.incidence = {0}};
    for (std::size_t i = 0; i < bins; ++i)
        for (const double x : rule.nodes)
            angles.exit_above.push_back((static_cast<double>(i) + x) * width);
    angles.exit_below = angles.exit_above;
    const reference::Illumination exact = reference::solve_layers(medium, angles, 48).collimated[0];
    AngularBins result{exact.budget, std::vector<double>(bins), std::vector<double>(bins)};
    for (std::size_t at = 0; at < angles.exit_above.size(); ++at) {
        const auto row = static_cast<Eigen::Index>(at);
        const double solid_angle =
            2 * std::numbers::pi * std::sin(angles.exit_above[at]) * width * rule.weights(row % 3);
        result.reflected[at / 3] += exact.reflected(row) * solid_angle;
        result.transmitted[at / 3] += exact.transmitted(row) * solid_angle;
    }
    return result;
}

}  // namespace gonio::test

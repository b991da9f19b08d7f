// SPDX-License-Identifier: Apache-2.0
// Phase functions as densities.
#include "reference/phase_density.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio::reference {
namespace {

using std::numbers::pi;

/// Henyey and Greenstein 1941, eq. 2.
double henyey_greenstein(double g, double cosine)
{
    return (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

struct Density {
    double cosine;

    double operator()(const HenyeyGreenstein& phase) const
    {
        return henyey_greenstein(phase.g, cosine);
    }
    double operator()(const Isotropic&) const { return 1 / (4 * pi); }
    double operator()(const Rayleigh&) const { return 3 * (1 + cosine * cosine) / (16 * pi); }
    double operator()(const TwoTermHenyeyGreenstein& phase) const
    {
        return phase.weight_1 * henyey_greenstein(phase.g_1, cosine) +
               (1 - phase.weight_1) * henyey_greenstein(phase.g_2, cosine);
    }
    double operator()(const TabulatedPhase& table) const
    {
        const auto& [x, value] = table;
        double whole = 0;
        for (std::size_t k = 1; k < x.size(); ++k)
            whole += (value[k] + value[k - 1]) / 2 * (x[k] - x[k - 1]);
        const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, cosine) - x.begin();
        const auto k = static_cast<std::size_t>(above);
        const double part = (cosine - x[k - 1]) / (x[k] - x[k - 1]);
        return std::lerp(value[k - 1], value[k], part) / (2 * pi * whole);
    }
};

}  // namespace

double phase_density(const PhaseFunction& phase, double cosine)
{
    return std::visit(Density{std::clamp(cosine, -1.0, 1.0)}, phase);
}

}  // namespace gonio::reference

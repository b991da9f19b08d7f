// SPDX-License-Identifier: Apache-2.0
// Legendre moments of phase functions, in closed form.
#include "reference/phase_moments.hpp"

#include <cmath>
#include <cstddef>

namespace gonio::reference {
namespace {

Eigen::VectorXd powers(double g, int count)
{
    Eigen::VectorXd moments(count);
    for (int l = 0; l < count; ++l) moments(l) = std::pow(g, l);
    return moments;
}

/// P_l(x) for l = 0 to count - 1, by Bonnet's recursion.
Eigen::VectorXd legendre_polynomials(double x, int count)
{
    Eigen::VectorXd p(count);
    p(0) = 1;
    if (count > 1) p(1) = x;
    for (int l = 1; l + 1 < count; ++l)
        p(l + 1) = ((2 * l + 1) * x * p(l) - l * p(l - 1)) / (l + 1);
    return p;
}

/// The antiderivative of the antiderivative of P_l at x, for l = 1 to count - 1, up to a constant:
/// each step is (P_{l+1} - P_{l-1}) / (2 l + 1).
Eigen::VectorXd integrated_twice(double x, int count)
{
    const Eigen::VectorXd p = legendre_polynomials(x, count + 2);
    Eigen::VectorXd once(count + 1), twice = Eigen::VectorXd::Zero(count);
    once(0) = x;
    for (int l = 1; l <= count; ++l) once(l) = (p(l + 1) - p(l - 1)) / (2 * l + 1);
    for (int l = 1; l < count; ++l) twice(l) = (once(l + 1) - once(l - 1)) / (2 * l + 1);
    return twice;
}

struct Moments {
    int count;

    Eigen::VectorXd operator()(const HenyeyGreenstein& phase) const
    {
        return powers(phase.g, count);
    }
    Eigen::VectorXd operator()(const Isotropic&) const { return powers(0, count); }
    Eigen::VectorXd operator()(const Rayleigh&) const
    {
        Eigen::VectorXd moments = powers(0, count);
        if (count > 2) moments(2) = 0.1;
        return moments;
    }
    Eigen::VectorXd operator()(const TwoTermHenyeyGreenstein& phase) const
    {
        return phase.weight_1 * powers(phase.g_1, count) +
               (1 - phase.weight_1) * powers(phase.g_2, count);
    }
    /// Two integrations by parts leave minus the slope times what integrated_twice gains along each
    /// piece.
    Eigen::VectorXd operator()(const TabulatedPhase& table) const
    {
        const auto& [x, value] = table;
        Eigen::VectorXd moments = Eigen::VectorXd::Zero(count);
        Eigen::VectorXd left = integrated_twice(x.front(), count);
        for (std::size_t i = 1; i < x.size(); ++i) {
            const Eigen::VectorXd right = integrated_twice(x[i], count);
            const double width = x[i] - x[i - 1];
            moments -= (value[i] - value[i - 1]) / width * (right - left);
            moments(0) += (value[i] + value[i - 1]) / 2 * width;
            left = right;
        }
        return moments / moments(0);
    }
};

}  // namespace

Eigen::VectorXd legendre_moments(const PhaseFunction& phase, int count)
{
    return std::visit(Moments{count}, phase);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Finds the root of reflectance by adding-doubling, which rises with the single-scattering albedo.
#include "photon/albedo_inversion.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <unsupported/Eigen/NonLinearOptimization>

#include "gonio/errors.hpp"
#include "parallel.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/phase_moments.hpp"

namespace gonio {
namespace {

constexpr int few_nodes = 16, most_nodes = 512;

/// A half-space by x = ln(s / (1 - s)), s^2 = (1 - alpha) / (1 - alpha g): reflectance is nearly
/// linear in s (van de Hulst, Multiple Light Scattering, 1980, chapter 11: similarity).
class HalfSpace {
public:
    explicit HalfSpace(const LightJob& light)
        : light_(light),
          g_(reference::legendre_moments(light.medium.layers.front().phase, 2)(1)),
          surface_(budget_at(0, few_nodes).specular)
    {
    }

    double surface() const { return surface_; }  ///< what it reflects with alpha = 0

    double alpha_at(double x) const
    {
        const double s = 1 / (1 + std::exp(-x));
        return (1 - s) * (1 + s) / (1 - g_ * s * s);
    }

    /// Where reflectance would be the albedo if 1 - s of what enters came back.
    double guess(double albedo) const
    {
        const double s = (1 - albedo) / (1 - surface_);
        return std::log(s / (1 - s));
    }

    double reflectance_at(double x, int nodes) const { return sum(budget_at(alpha_at(x), nodes)); }

    /// With a bound of its error.
    Fraction reflectance_with_error_at(double x, int nodes) const
    {
        const auto solution = reference::solve_layers(medium(alpha_at(x)), request(), nodes);
        return {sum(solution.under(light_.light).budget), solution.error};
    }

    int nodes_for(double x, double tolerance) const
    {
        return reference::solve_layers_to(medium(alpha_at(x)), request(), tolerance).nodes;
    }

private:
    static double sum(const reference::LightBudget& budget)
    {
        return budget.specular + budget.diffuse_reflectance;
    }

    LayeredMedium medium(double alpha) const
    {
        LayeredMedium medium = light_.medium;
        medium.layers.front().mus = alpha;  // extinction 1: an infinite layer has no other length
        medium.layers.front().mua = 1 - alpha;
        return medium;
    }

    reference::LightRequest request() const { return {.incidence = {light_.light.incidence}}; }

    reference::LightBudget budget_at(double alpha, int nodes) const
    {
        return reference::solve_layers_once(medium(alpha), request(), nodes)
            .under(light_.light)
            .budget;
    }

    const LightJob& light_;
    double g_, surface_;
};

/// What Eigen's solver makes 0.
struct Misfit {
    const HalfSpace& half_space;
    double albedo;
    int nodes;

    int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& off) const
    {
        off(0) = half_space.reflectance_at(x(0), nodes) - albedo;
        return 0;
    }
};

/// Powell's hybrid method (MINPACK's hybrd), from x on.
double root(const HalfSpace& half_space, double albedo, int nodes, double x, double tolerance)
{
    Misfit misfit{half_space, albedo, nodes};
    Eigen::HybridNonLinearSolver<Misfit> solver(misfit);
    solver.parameters.xtol = tolerance;
    Eigen::VectorXd at = Eigen::VectorXd::Constant(1, x);
    solver.solveNumericalDiff(at);
    return at(0);
}

/// What scatters so, and how far its albedo is off.
struct Inverted {
    Fraction alpha;
    double off = 0;
    int nodes = 0;
};

/// Few nodes until the root is near, then as many as the tolerance needs.
Inverted invert(const HalfSpace& half_space, double albedo, double tolerance)
{
    if (albedo == 1) return {{1, 0}};
    if (albedo <= half_space.surface()) return {{0, 0}};
    double x = root(half_space, albedo, few_nodes, half_space.guess(albedo), 1e-3);
    constexpr double step = 1e-2;
    const double rise =
        (half_space.reflectance_at(x + step, few_nodes) - half_space.reflectance_at(x, few_nodes)) /
        (half_space.alpha_at(x + step) - half_space.alpha_at(x));
    for (int nodes = half_space.nodes_for(x, tolerance); nodes <= most_nodes; nodes *= 2) {
        x = root(half_space, albedo, nodes, x, tolerance / 10);
        const auto [found, error] = half_space.reflectance_with_error_at(x, nodes);
        const double off = error + std::abs(found - albedo);
        if (off <= tolerance) return {{half_space.alpha_at(x), off / rise}, off, nodes};
    }
    throw RunError(fmt::format("adding-doubling did not reach an error of {:.1e} of the albedo {}",
                               tolerance, albedo));
}

}  // namespace

void check_inversion(const LightJob& light, const Axis& albedos)
{
    const LayeredMedium& medium = light.medium;
    if (medium.layers.size() != 1 || std::isfinite(medium.layers.front().d))
        throw UsageError(
            fmt::format("the quantity `{}` is that of a half-space: one layer without `d`",
                        light.quantity->id));
    const double surface = HalfSpace(light).surface();
    for (const double albedo : albedos.values)
        if (!(albedo >= surface && albedo <= 1))
            throw UsageError(fmt::format(
                "`albedo` is {}; allowed is {:.6g}, which the surface reflects alone, to 1", albedo,
                surface));
}

ExactValues invert_albedos(const LightJob& light, const Axis& albedos,
                           const reference::AfterPart& after_part)
{
    const HalfSpace half_space(light);
    const double tolerance = tolerance_of(light);
    ExactValues result{std::vector<Fraction>(albedos.values.size()), 0};
    std::mutex guard;
    double done = 0;
    in_parallel(albedos.values.size(), [&](std::size_t k) {
        const Inverted found = invert(half_space, albedos.values[k], tolerance);
        result.values[k] = found.alpha;
        const std::scoped_lock lock(guard);
        result.nodes = std::max(result.nodes, found.nodes);
        result.error = std::max(result.error, found.off);
        after_part(++done / static_cast<double>(albedos.values.size()));
    });
    return result;
}

}  // namespace gonio

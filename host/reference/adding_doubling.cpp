// SPDX-License-Identifier: Apache-2.0
// Budgets, intensities and BRDFs of layered media from the operators of adding-doubling.
#include "reference/adding_doubling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "gonio/errors.hpp"
#include "reference/adding_doubling/interface.hpp"
#include "reference/adding_doubling/stack.hpp"

namespace gonio::reference {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

/// Light from above.
struct Light {
    VectorXd flux;       ///< in each direction
    double density = 0;  ///< diffuse light: flux per q, also where directions have no measure
};

/// A medium solved with one number of nodes.
class Solved {
public:
    Solved(const LayeredMedium& medium, const std::vector<Direction>& exact, int nodes)
        : directions_(choose_directions(medium, nodes, exact)),
          stack_(add_layers(medium, directions_, 0)),
          unscattered_(follow_unscattered(medium, directions_)),
          specular_(specular_reflectance(medium, directions_))
    {
    }

    Light lambertian(double n_above) const
    {
        Light light{VectorXd::Zero(directions_.root_weight.size()), 1 / (n_above * n_above)};
        for (Index i = 0; i < directions_.quadrature; ++i) {
            const double weight = directions_.root_weight(i) * directions_.root_weight(i);
            if (directions_.all[std::size_t(i)].normal_squared(n_above) > 0) {
                light.flux(i) = weight * light.density;
            }
        }
        return light;
    }

    /// In the exact direction `place`.
    Light collimated(std::size_t place) const
    {
        return {
            VectorXd::Unit(directions_.root_weight.size(), directions_.quadrature + Index(place))};
    }

    LightBudget budget(const Light& light) const
    {
        const VectorXd& worth = directions_.root_weight;
        const VectorXd light_in = light.flux.cwiseQuotient(worth);
        const double reflected = worth_before(worth, stack_.reflection).dot(light_in);
        const double transmitted = worth_before(worth, stack_.transmission).dot(light_in);
        const VectorXd kept = stack_.kept * light.flux;
        const double specular = specular_.matrix().dot(light.flux);
        const double unscattered = unscattered_.transmitted.matrix().dot(light.flux);
        return {.specular = specular,
                .diffuse_reflectance = reflected - specular,
                .unscattered_transmittance = unscattered,
                .diffuse_transmittance = transmitted - unscattered,
                .absorption = {kept.begin(), kept.end() - 1},
                .bottom_absorption = kept(kept.size() - 1) - transmitted};
    }

    /// Scattered radiant intensity, 1/sr, at `count` exact directions from `place` on.
    VectorXd reflected(const Light& light, std::size_t place, std::size_t count) const
    {
        return intensity(light, stack_.reflection, unscattered_.reflected, place, count);
    }
    VectorXd transmitted(const Light& light, std::size_t place, std::size_t count) const
    {
        return intensity(light, stack_.transmission, unscattered_.transmitted, place, count);
    }

private:
    VectorXd intensity(const Light& light, const LightOperator& stack,
                       const Eigen::ArrayXd& unscattered, std::size_t place,
                       std::size_t count) const
    {
        const auto rows = Eigen::seqN(directions_.quadrature + Index(place), Index(count));
        VectorXd flux =
            stack.kernel(rows, Eigen::all) * light.flux.cwiseQuotient(directions_.root_weight);
        flux += light.density * (stack.diagonal.array() - unscattered)(rows).matrix();
        // From per q to per solid angle: dq = n^2 cos dOmega / pi.
        for (std::size_t i = 0; i < count; ++i) {
            const Direction& exit = directions_.all[std::size_t(rows.first()) + i];
            flux(Index(i)) *= exit.n * exit.n * exit.cosine / pi;
        }
        return flux;
    }

    Directions directions_;
    Stack stack_;
    Interface unscattered_;
    Eigen::ArrayXd specular_;
};

LayeredSolution solve_once(const LayeredMedium& medium, const LightRequest& request, int nodes)
{
    const auto incidence = directions_at(medium.n_above, request.incidence);
    const auto above = directions_at(medium.n_above, request.exit_above);
    const auto below = directions_at(medium.n_below, request.exit_below);
    std::vector<Direction> exact = incidence;
    exact.insert(exact.end(), above.begin(), above.end());
    exact.insert(exact.end(), below.begin(), below.end());
    const Solved solved(medium, exact, nodes);
    const auto illuminated = [&](const Light& light) {
        return Illumination{
            solved.budget(light), solved.reflected(light, incidence.size(), above.size()),
            solved.transmitted(light, incidence.size() + above.size(), below.size())};
    };
    LayeredSolution solution;
    for (std::size_t i = 0; i < incidence.size(); ++i) {
        solution.collimated.push_back(illuminated(solved.collimated(i)));
    }
    solution.diffuse = illuminated(solved.lambertian(medium.n_above));
    solution.nodes = nodes;
    return solution;
}

double largest_difference(const LightBudget& a, const LightBudget& b)
{
    double largest = std::max({std::abs(a.specular - b.specular),
                               std::abs(a.diffuse_reflectance - b.diffuse_reflectance),
                               std::abs(a.unscattered_transmittance - b.unscattered_transmittance),
                               std::abs(a.diffuse_transmittance - b.diffuse_transmittance),
                               std::abs(a.bottom_absorption - b.bottom_absorption)});
    for (std::size_t i = 0; i < a.absorption.size(); ++i) {
        largest = std::max(largest, std::abs(a.absorption[i] - b.absorption[i]));
    }
    return largest;
}

double largest_difference(const VectorXd& a, const VectorXd& b)
{
    const double scale = a.size() > 0 ? a.cwiseAbs().maxCoeff() : 0;
    return scale > 0 ? (a - b).cwiseAbs().maxCoeff() / scale : 0;
}

/// Sets the errors of a solution by a coarser one.
void compare(LayeredSolution& solution, const LayeredSolution& coarse)
{
    double budget = 0, angular = 0;
    const auto add = [&](const Illumination& a, const Illumination& b) {
        budget = std::max(budget, largest_difference(a.budget, b.budget));
        angular = std::max({angular, largest_difference(a.reflected, b.reflected),
                            largest_difference(a.transmitted, b.transmitted)});
    };
    for (std::size_t i = 0; i < coarse.collimated.size(); ++i) {
        add(solution.collimated[i], coarse.collimated[i]);
    }
    add(solution.diffuse, coarse.diffuse);
    solution.error = error_over_difference * budget;
    solution.angular_error = error_over_difference * angular;
}

}  // namespace

LayeredSolution solve_layers(const LayeredMedium& medium, const LightRequest& request, int nodes)
{
    validate(medium);
    LayeredSolution solution = solve_once(medium, request, nodes);
    compare(solution, solve_once(medium, request, coarser(nodes)));
    return solution;
}

LayeredSolution solve_layers_to(const LayeredMedium& medium, const LightRequest& request,
                                double tolerance)
{
    constexpr double first = 24, most = 512;
    validate(medium);
    LayeredSolution coarse = solve_once(medium, request, coarser(int(first)));
    for (double nodes = first; nodes <= most; nodes *= std::numbers::sqrt2) {
        LayeredSolution solution =
            solve_once(medium, request, static_cast<int>(std::lround(nodes)));
        compare(solution, coarse);
        if (solution.error <= tolerance) return solution;
        coarse = std::move(solution);
    }
    throw RunError(
        fmt::format("adding-doubling reached an error of {:.1e} and not {:.1e} with {} nodes",
                    coarse.error, tolerance, coarse.nodes));
}

}  // namespace gonio::reference

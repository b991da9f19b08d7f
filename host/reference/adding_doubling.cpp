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
#include "reference/adding_doubling/told_slabs.hpp"

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
struct Solved {
    Directions directions;
    Stack stack;
    Interface unscattered;
    Eigen::ArrayXd specular;
};

Light lambertian(const Directions& directions, double n_above)
{
    Light light{VectorXd::Zero(directions.size()), 1 / (n_above * n_above)};
    for (Index i = 0; i < directions.quadrature; ++i) {
        if (directions.all[std::size_t(i)].normal_squared(n_above) <= 0) continue;
        light.flux(i) = directions.root_weight(i) * directions.root_weight(i) * light.density;
    }
    return light;
}

LightBudget budget(const Solved& solved, const Light& light)
{
    const VectorXd& worth = solved.directions.root_weight;
    const VectorXd in = light.flux.cwiseQuotient(worth);
    const double reflected = worth_before(worth, solved.stack.reflection).dot(in);
    const double transmitted = worth_before(worth, solved.stack.transmission).dot(in);
    const VectorXd kept = solved.stack.kept * light.flux;
    const double specular = solved.specular.matrix().dot(light.flux);
    const double unscattered = solved.unscattered.transmitted.matrix().dot(light.flux);
    return {.specular = specular,
            .diffuse_reflectance = reflected - specular,
            .unscattered_transmittance = unscattered,
            .diffuse_transmittance = transmitted - unscattered,
            .absorption = {kept.begin(), kept.end() - 1},
            .bottom_absorption = kept(kept.size() - 1) - transmitted};
}

/// What `side` of the stack sends into exact directions besides the part of its diagonal that is
/// specular.
VectorXd intensity(const Directions& directions, const Light& light, const LightOperator& side,
                   const Eigen::ArrayXd& specular, const Places& exits)
{
    VectorXd flux =
        side.kernel(exits, Eigen::all) * light.flux.cwiseQuotient(directions.root_weight);
    flux += light.density * (side.diagonal.array() - specular)(exits).matrix();
    for (std::size_t i = 0; i < exits.size(); ++i) {  // per solid angle: dq = n^2 cos dOmega / pi
        const Direction& exit = directions.all[std::size_t(exits[i])];
        flux(Index(i)) *= exit.n * exit.n * exit.cosine / pi;
    }
    return flux;
}

LayeredSolution solve_once(const LayeredMedium& medium, const LightRequest& request, int nodes,
                           const SlabSolver& solver = solve_slab)
{
    ExactDirections exact;
    const Places incidence = exact.add(medium.n_above, request.incidence);
    const Places above = exact.add(medium.n_above, request.exit_above);
    const Places below = exact.add(medium.n_below, request.exit_below);
    const Directions directions = choose_directions(medium, nodes, exact);
    const Solved solved{directions, add_layers(medium, directions, 0, solver),
                        follow_unscattered(medium, directions),
                        specular_reflectance(medium, directions)};
    const Eigen::ArrayXd nothing = Eigen::ArrayXd::Zero(directions.size());
    const auto illuminated = [&](const Light& light) {
        return Illumination{
            budget(solved, light),
            intensity(directions, light, solved.stack.reflection, solved.specular,
                      directions.of_exact(above)),
            intensity(directions, light, solved.stack.transmission, nothing,
                      directions.of_exact(below)),
            (solved.stack.reflection.diagonal - solved.specular.matrix()).dot(light.flux),
            solved.stack.transmission.diagonal.dot(light.flux)};
    };
    LayeredSolution solution;
    for (const Index place : directions.of_exact(incidence)) {
        solution.collimated.push_back(illuminated({VectorXd::Unit(directions.size(), place), 0}));
    }
    solution.diffuse = illuminated(lambertian(directions, medium.n_above));
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

LayeredSolution solve_layers_once(const LayeredMedium& medium, const LightRequest& request,
                                  int nodes, const SlabSolver& solver)
{
    validate(medium);
    return solve_once(medium, request, nodes, solver);
}

LayeredSolution solve_layers(const LayeredMedium& medium, const LightRequest& request, int nodes)
{
    validate(medium);
    LayeredSolution solution = solve_once(medium, request, nodes);
    compare(solution, solve_once(medium, request, coarser(nodes)));
    return solution;
}

LayeredSolution solve_layers_to(const LayeredMedium& medium, const LightRequest& request,
                                double tolerance, const AfterPart& after_part,
                                const GoesOn& goes_on)
{
    constexpr double most = 512;
    validate(medium);
    const std::size_t exact =
        request.incidence.size() + request.exit_above.size() + request.exit_below.size();
    const auto solve = [&](int nodes, const AfterPart& after) {
        ToldSlabs slabs(static_cast<double>(medium.layers.size()), after);
        return solve_once(medium, request, nodes, std::ref(slabs));
    };
    const auto error_of = [](LayeredSolution& solution, const LayeredSolution& coarse) {
        compare(solution, coarse);
        return std::max(solution.error, solution.angular_error);
    };
    auto [solution, error, enough] =
        refine({tolerance, most, exact}, after_part, goes_on, solve, error_of);
    if (enough) return std::move(solution);
    throw RunError(
        fmt::format("adding-doubling reached an error of {:.1e} and not {:.1e} with {} nodes",
                    error, tolerance, solution.nodes));
}

}  // namespace gonio::reference

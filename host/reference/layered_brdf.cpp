// SPDX-License-Identifier: Apache-2.0
// Azimuth modes of adding-doubling, summed with their cosines.
#include "reference/layered_brdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/errors.hpp"
#include "reference/adding_doubling/directions.hpp"
#include "reference/adding_doubling/single_scattering.hpp"
#include "reference/adding_doubling/stack.hpp"

namespace gonio::reference {
namespace {

using Eigen::Index;

LayeredBrdf sum_modes(const LayeredMedium& medium, const std::vector<double>& theta_i,
                      const std::vector<double>& theta_o, const std::vector<double>& delta_phi,
                      int nodes, const std::function<void()>& after_mode)
{
    constexpr double negligible = 1e-10;  // of the azimuthal mean's largest
    ExactDirections exact;
    const Places incident = exact.add(medium.n_above, theta_i);
    const Places exits = exact.add(medium.n_above, theta_o);
    const Directions directions = choose_directions(medium, nodes, exact);

    LayeredBrdf brdf;
    brdf.nodes = nodes;
    brdf.values.assign(theta_i.size() * theta_o.size() * delta_phi.size(), 0);
    // From flux per q to radiance: dq = n^2 cos dOmega / pi.
    const double radiance = medium.n_above * medium.n_above / std::numbers::pi;
    double mean = 0, largest = 0;
    do {
        const LightOperator reflection = add_layers(medium, directions, brdf.modes).reflection;
        const Eigen::MatrixXd mode =
            (brdf.modes == 0 ? 1 : 2) * radiance *
            reflection.kernel(directions.of_exact(exits), directions.of_exact(incident));
        auto value = brdf.values.begin();
        for (Index i = 0; i < mode.cols(); ++i) {
            for (Index o = 0; o < mode.rows(); ++o) {
                for (const double phi : delta_phi) {
                    *value++ += mode(o, i) * std::cos(brdf.modes * phi);
                }
            }
        }
        largest = mode.cwiseAbs().maxCoeff();
        mean = std::max(mean, largest);
        ++brdf.modes;
        after_mode();
    } while (largest > negligible * mean);
    const SingleScattering once(medium, directions);
    auto value = brdf.values.begin();
    for (const double in : theta_i)
        for (const double out : theta_o)
            for (const double phi : delta_phi) *value++ += once(in, out, phi);
    return brdf;
}

void compare(LayeredBrdf& brdf, const LayeredBrdf& coarse)
{
    for (std::size_t i = 0; i < brdf.values.size(); ++i) {
        const double difference = std::abs(brdf.values[i] - coarse.values[i]);
        brdf.error = std::max(brdf.error, error_over_difference * difference);
    }
}

}  // namespace

LayeredBrdf layered_brdf(const LayeredMedium& medium, const std::vector<double>& theta_i,
                         const std::vector<double>& theta_o, const std::vector<double>& delta_phi,
                         int nodes)
{
    validate(medium);
    LayeredBrdf brdf = sum_modes(medium, theta_i, theta_o, delta_phi, nodes, [] {});
    compare(brdf, sum_modes(medium, theta_i, theta_o, delta_phi, coarser(nodes), [] {}));
    return brdf;
}

LayeredBrdf layered_brdf_to(const LayeredMedium& medium, const std::vector<double>& theta_i,
                            const std::vector<double>& theta_o,
                            const std::vector<double>& delta_phi, double tolerance,
                            const std::function<void()>& after_mode)
{
    constexpr double first = 24, most = 256;
    validate(medium);
    LayeredBrdf coarse =
        sum_modes(medium, theta_i, theta_o, delta_phi, coarser(int(first)), after_mode);
    double reached = 0;
    for (double nodes = first; nodes <= most; nodes *= std::numbers::sqrt2) {
        LayeredBrdf brdf = sum_modes(medium, theta_i, theta_o, delta_phi,
                                     static_cast<int>(std::lround(nodes)), after_mode);
        compare(brdf, coarse);
        reached = brdf.error / std::ranges::max(brdf.values);
        if (reached <= tolerance) return brdf;
        coarse = std::move(brdf);
    }
    throw RunError(fmt::format(
        "adding-doubling of the BRDF reached an error of {:.1e} of its largest value and not "
        "{:.1e} with {} nodes; solver = \"monte_carlo\" does not need them",
        reached, tolerance, coarse.nodes));
}

}  // namespace gonio::reference

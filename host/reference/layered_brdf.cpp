// SPDX-License-Identifier: Apache-2.0
// Azimuth modes of adding-doubling, summed with their cosines.
#include "reference/layered_brdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include "gonio/errors.hpp"
#include "parallel.hpp"
#include "reference/adding_doubling/single_scattering.hpp"
#include "reference/adding_doubling/stack.hpp"
#include "reference/adding_doubling/told_slabs.hpp"

namespace gonio::reference {
namespace {

using Eigen::Index;

/// The angles of a BRDF, in rad.
struct Angles {
    const std::vector<double>&theta_i, &theta_o, &delta_phi;

    std::size_t cells() const { return theta_i.size() * theta_o.size() * delta_phi.size(); }
};

/// Adds up the modes until they fade; as many as there are processors are solved at a time.
class Modes {
public:
    Modes(const LayeredMedium& medium, const Angles& angles, int nodes, ToldSlabs& slabs)
        : medium_(medium), angles_(angles), slabs_(slabs)
    {
        ExactDirections exact;
        incident_ = exact.add(medium.n_above, angles.theta_i);
        exits_ = exact.add(medium.n_above, angles.theta_o);
        directions_ = choose_directions(medium, nodes, exact);
        brdf_.values.assign(angles.cells(), 0);
        brdf_.nodes = nodes;
    }

    LayeredBrdf sum()
    {
        std::vector<Eigen::MatrixXd> modes(std::max(std::thread::hardware_concurrency(), 1U));
        for (bool fading = false; !fading;) {
            in_parallel(modes.size(), [&](std::size_t k) {
                modes[k] = solve(brdf_.modes + static_cast<int>(k));
            });
            for (auto mode = modes.begin(); mode != modes.end() && !fading; ++mode)
                fading = !add(*mode);
        }
        const SingleScattering once(medium_, directions_, angles_.delta_phi);
        const std::size_t stride = angles_.theta_o.size() * angles_.delta_phi.size();
        in_parallel(angles_.theta_i.size(), [&](std::size_t i) {
            auto value = brdf_.values.begin() + static_cast<std::ptrdiff_t>(i * stride);
            for (const double out : angles_.theta_o)
                for (const double light : once(angles_.theta_i[i], out)) *value++ += light;
            slabs_.tell();
        });
        return std::move(brdf_);
    }

private:
    /// Radiance, [theta_o][theta_i].
    Eigen::MatrixXd solve(int mode) const
    {
        // From flux per q to radiance: dq = n^2 cos dOmega / pi.
        const double radiance = medium_.n_above * medium_.n_above / std::numbers::pi;
        const Stack stack = add_layers(medium_, directions_, mode, std::ref(slabs_));
        return (mode == 0 ? 1 : 2) * radiance *
               stack.reflection.kernel(directions_.of_exact(exits_),
                                       directions_.of_exact(incident_));
    }

    /// Is there more than next to nothing in it?
    bool add(const Eigen::MatrixXd& mode)
    {
        constexpr double negligible = 1e-10;  // of the azimuthal mean's largest
        std::vector<double> cosines;
        for (const double phi : angles_.delta_phi) cosines.push_back(std::cos(brdf_.modes * phi));
        auto value = brdf_.values.begin();
        for (Index i = 0; i < mode.cols(); ++i)
            for (Index o = 0; o < mode.rows(); ++o)
                for (const double cosine : cosines) *value++ += mode(o, i) * cosine;
        const double largest = mode.cwiseAbs().maxCoeff();
        mean_ = std::max(mean_, largest);
        ++brdf_.modes;
        return largest > negligible * mean_;
    }

    const LayeredMedium& medium_;
    Angles angles_;
    ToldSlabs& slabs_;
    Places incident_, exits_;
    Directions directions_;
    LayeredBrdf brdf_;
    double mean_ = 0;
};

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
    ToldSlabs slabs(INFINITY, [](double) {});
    const Angles angles{theta_i, theta_o, delta_phi};
    LayeredBrdf brdf = Modes(medium, angles, nodes, slabs).sum();
    compare(brdf, Modes(medium, angles, coarser(nodes), slabs).sum());
    return brdf;
}

LayeredBrdf layered_brdf_to(const LayeredMedium& medium, const std::vector<double>& theta_i,
                            const std::vector<double>& theta_o,
                            const std::vector<double>& delta_phi, double tolerance,
                            const AfterPart& after_part, const GoesOn& goes_on)
{
    constexpr double most = 256;
    validate(medium);
    const Angles angles{theta_i, theta_o, delta_phi};
    double expected = INFINITY;  // slabs: more nodes need about as many modes
    const auto solve = [&](int nodes, const AfterPart& after) {
        ToldSlabs slabs(expected, after);
        LayeredBrdf brdf = Modes(medium, angles, nodes, slabs).sum();
        expected = static_cast<double>(medium.layers.size()) * brdf.modes;
        return brdf;
    };
    const auto error_of = [](LayeredBrdf& brdf, const LayeredBrdf& coarse) {
        compare(brdf, coarse);
        return brdf.error / std::ranges::max(brdf.values);
    };
    auto [brdf, error, enough] = refine({tolerance, most, theta_i.size() + theta_o.size()},
                                        after_part, goes_on, solve, error_of);
    if (enough) return std::move(brdf);
    throw RunError(fmt::format(
        "adding-doubling of the BRDF reached an error of {:.1e} of its largest value and not "
        "{:.1e} with {} nodes; solver = \"monte_carlo\" does not need them",
        error, tolerance, brdf.nodes));
}

}  // namespace gonio::reference

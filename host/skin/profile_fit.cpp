// SPDX-License-Identifier: Apache-2.0
// Fits sums of Gaussians and Burley's function to the light in rings. What a function has in a ring
// is its exact integral.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/errors.hpp"
#include "gonio/profile.hpp"

namespace gonio {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index terms = 6;
// Where the narrowest Gaussian and the factor between neighbours are looked for: from some microns
// to many centimetres.
constexpr double least_variance = 1e-5, greatest_variance = 0.1;  // mm^2
constexpr double least_factor = 2, greatest_factor = 16;
constexpr int tried = 24;                                         // of each
constexpr double least_distance = 1e-3, greatest_distance = 100;  // mm

/// Light in a ring to the root of what it adds to the integral of r R(r)^2 dr, but for a factor.
VectorXd ring_scales(const RadialProfile& profile)
{
    const auto rings = static_cast<Index>(profile.rings[0].size());
    return (VectorXd::LinSpaced(rings, 0.5, static_cast<double>(rings) - 0.5))
        .cwiseSqrt()
        .cwiseInverse();
}

VectorXd measured(const RadialProfile& profile, std::size_t channel)
{
    VectorXd light(static_cast<Index>(profile.rings[channel].size()));
    for (Index k = 0; k < light.size(); ++k)
        light(k) = profile.rings[channel][static_cast<std::size_t>(k)].mean;
    return light.cwiseProduct(ring_scales(profile));
}

/// The part beyond a radius at each ring's edges, as differences.
template <typename Beyond>
VectorXd in_rings(const RadialProfile& profile, const Beyond& beyond)
{
    VectorXd light(static_cast<Index>(profile.rings[0].size()));
    double inner = 1;
    for (Index k = 0; k < light.size(); ++k) {
        const double outer = beyond(static_cast<double>(k + 1) * profile.width * 10);
        light(k) = inner - outer;
        inner = outer;
    }
    return light.cwiseProduct(ring_scales(profile));
}

MatrixXd gaussians(const RadialProfile& profile, const VectorXd& variances)
{
    MatrixXd all(static_cast<Index>(profile.rings[0].size()), terms);
    for (Index k = 0; k < terms; ++k)
        all.col(k) =
            in_rings(profile, [&](double r) { return std::exp(-r * r / (2 * variances(k))); });
    return all;
}

/// min |triangle w - wanted| with w >= 0. The best is the best without bounds of those terms that
/// are not 0 in it, and six terms have 64 subsets.
VectorXd non_negative(const MatrixXd& triangle, const VectorXd& wanted)
{
    VectorXd best = VectorXd::Zero(terms);
    double least = wanted.squaredNorm();
    for (unsigned subset = 1; subset < 1U << terms; ++subset) {
        std::vector<Index> chosen;
        for (Index k = 0; k < terms; ++k)
            if (subset >> k & 1) chosen.push_back(k);
        const MatrixXd part = triangle(Eigen::all, chosen);
        const VectorXd weights = part.colPivHouseholderQr().solve(wanted);
        const double left = (part * weights - wanted).squaredNorm();
        if (weights.minCoeff() < 0 || left >= least) continue;
        least = left;
        best.setZero();
        best(chosen) = weights;
    }
    return best;
}

struct Weights {
    std::array<VectorXd, 3> of;
    std::array<double, 3> error;

    double squares() const
    {
        return error[0] * error[0] + error[1] * error[1] + error[2] * error[2];
    }
};

/// The best weights of these Gaussians, scaled to all the light that returns.
Weights weigh(const RadialProfile& profile, const std::array<VectorXd, 3>& light,
              const VectorXd& variances)
{
    const MatrixXd shapes = gaussians(profile, variances);
    const Eigen::HouseholderQR<MatrixXd> qr(shapes);
    const Index known = std::min(terms, shapes.rows());  // few rings leave some terms open
    const MatrixXd triangle = qr.matrixQR().topRows(known).triangularView<Eigen::Upper>();
    Weights found;
    for (std::size_t c = 0; c < 3; ++c) {
        const VectorXd turned = qr.householderQ().adjoint() * light[c];
        VectorXd weights = non_negative(triangle, turned.head(known));
        if (weights.sum() > 0) weights *= std::max(profile.total[c].mean, 0.0) / weights.sum();
        const double norm = light[c].norm();
        found.error[c] = norm > 0 ? (shapes * weights - light[c]).norm() / norm : 0;
        found.of[c] = weights;
    }
    return found;
}

double between(double least, double greatest, int step)
{
    return least * std::pow(greatest / least, static_cast<double>(step) / (tried - 1));
}

}  // namespace

ProfileFit<SumOfGaussians> fit_gaussians(const RadialProfile& profile)
{
    const std::array<VectorXd, 3> light = {measured(profile, 0), measured(profile, 1),
                                           measured(profile, 2)};
    Weights best;
    VectorXd variances;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tried; ++i)
        for (int j = 0; j < tried; ++j) {
            VectorXd tries(terms);
            tries(0) = between(least_variance, greatest_variance, i);
            for (Index k = 1; k < terms; ++k)
                tries(k) = tries(k - 1) * between(least_factor, greatest_factor, j);
            const Weights found = weigh(profile, light, tries);
            if (found.squares() >= least) continue;
            least = found.squares();
            best = found;
            variances = tries;
        }
    ProfileFit<SumOfGaussians> fit{{{variances.begin(), variances.end()}, {}}, best.error};
    for (Index k = 0; k < terms; ++k)
        fit.function.weights.push_back({best.of[0](k), best.of[1](k), best.of[2](k)});
    return fit;
}

ProfileFit<BurleyProfile> fit_burley(const RadialProfile& profile)
{
    ProfileFit<BurleyProfile> fit{};
    for (std::size_t c = 0; c < 3; ++c) {
        const VectorXd light = measured(profile, c);
        const double albedo = profile.total[c].mean;
        if (!(albedo > 0))
            throw RunError(fmt::format("channel {} returns no light to fit", "RGB"[c]));
        const auto error = [&](double log_distance) {
            const double d = std::exp(log_distance);
            const auto beyond = [&](double r) {
                return 0.25 * std::exp(-r / d) + 0.75 * std::exp(-r / (3 * d));
            };
            return (albedo * in_rings(profile, beyond) - light).norm() / light.norm();
        };
        // Scans that close in on the least.
        double from = std::log(least_distance), to = std::log(greatest_distance), best = from;
        while (to - from > 1e-6) {
            const double step = (to - from) / tried;
            best = from;
            for (int k = 1; k <= tried; ++k)
                if (error(from + k * step) < error(best)) best = from + k * step;
            from = best - step;
            to = best + step;
        }
        fit.function.albedo[c] = albedo;
        fit.function.distance[c] = std::exp(best);
        fit.error[c] = error(best);
    }
    return fit;
}

}  // namespace gonio

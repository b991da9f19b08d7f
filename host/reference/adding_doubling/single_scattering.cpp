// SPDX-License-Identifier: Apache-2.0
// What truncation takes from light that is scattered once.
#include "reference/adding_doubling/single_scattering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/adding_doubling/redistribution.hpp"
#include "reference/fresnel.hpp"
#include "reference/phase_density.hpp"

namespace gonio::reference {
namespace {

/// The sum of (2 l + 1) / (4 pi) times moment l times P_l at each x, by Bonnet's recursion.
Eigen::ArrayXd sum_of_moments(const Eigen::VectorXd& moments, const Eigen::ArrayXd& x)
{
    Eigen::ArrayXd before = Eigen::ArrayXd::Zero(x.size()), now = Eigen::ArrayXd::Ones(x.size());
    Eigen::ArrayXd sum = before;
    for (Eigen::Index l = 0; l < moments.size(); ++l) {
        const double degree = static_cast<double>(l);
        sum += (2 * degree + 1) * moments(l) * now;
        before = (2 * degree + 1) / (degree + 1) * x * now - degree / (degree + 1) * before;
        before.swap(now);
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace

SingleScattering::SingleScattering(const LayeredMedium& medium, const Directions& directions,
                                   const std::vector<double>& delta_phi)
    : n_above_(medium.n_above),
      cosines_(Eigen::Map<const Eigen::ArrayXd>(delta_phi.data(), std::ssize(delta_phi)).cos())
{
    for (const Layer& layer : medium.layers) {
        const TruncatedPhase phase = truncate(layer.phase, LocalDirections(directions, layer.n));
        const double smooth = layer.mus * phase.rest();
        layers_.push_back(
            {&layer, layer.mua + smooth + layer.mus * phase.backward, smooth, phase.moments});
    }
}

Eigen::ArrayXd SingleScattering::difference(const Scatterer& layer, const Eigen::ArrayXd& cosines)
{
    const auto density = [&](double cosine) { return phase_density(layer.layer->phase, cosine); };
    return layer.layer->mus * cosines.unaryExpr(density) -
           layer.smooth * sum_of_moments(layer.moments, cosines);
}

Eigen::ArrayXd SingleScattering::operator()(double theta_i, double theta_o) const
{
    const Direction in{n_above_, std::cos(theta_i)}, out{n_above_, std::cos(theta_o)};
    double n = n_above_, cosine_i = in.cosine, cosine_o = out.cosine, passes = 1;
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(cosines_.size());
    for (const Scatterer& scatterer : layers_) {
        const Layer& layer = *scatterer.layer;
        const double squared_i = in.normal_squared(layer.n),
                     squared_o = out.normal_squared(layer.n);
        if (squared_i <= 0 || squared_o <= 0) return sum;
        passes *= (1 - fresnel_exact(layer.n / n, 0, cosine_i)) *
                  (1 - fresnel_exact(layer.n / n, 0, cosine_o));
        n = layer.n;
        cosine_i = std::sqrt(squared_i) / n;
        cosine_o = std::sqrt(squared_o) / n;
        const double depth = scatterer.extinction * layer.d * (1 / cosine_i + 1 / cosine_o);
        if (layer.mus > 0) {
            const double sines =
                std::sqrt((1 - cosine_i) * (1 + cosine_i) * (1 - cosine_o) * (1 + cosine_o));
            const double light = passes * std::pow(n_above_ / n, 2) * -std::expm1(-depth) /
                                 (scatterer.extinction * (cosine_i + cosine_o));
            sum += light * difference(scatterer, sines * cosines_ - cosine_i * cosine_o);
        }
        passes *= std::exp(-depth);
    }
    return sum;
}

}  // namespace gonio::reference

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

/// The sum of (2 l + 1) / (4 pi) times moment l times P_l(x), by Bonnet's recursion.
double sum_of_moments(const Eigen::VectorXd& moments, double x)
{
    double before = 0, now = 1, sum = 0;
    for (Eigen::Index l = 0; l < moments.size(); ++l) {
        const double degree = static_cast<double>(l);
        sum += (2 * degree + 1) * moments(l) * now;
        const double next = ((2 * degree + 1) * x * now - degree * before) / (degree + 1);
        before = now;
        now = next;
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace

SingleScattering::SingleScattering(const LayeredMedium& medium, const Directions& directions)
    : n_above_(medium.n_above)
{
    for (const Layer& layer : medium.layers) {
        const TruncatedPhase phase = truncate(layer.phase, LocalDirections(directions, layer.n));
        const double smooth = layer.mus * phase.rest();
        layers_.push_back(
            {&layer, layer.mua + smooth + layer.mus * phase.backward, smooth, phase.moments});
    }
}

double SingleScattering::difference(const Scatterer& layer, double cosine) const
{
    return layer.layer->mus * phase_density(layer.layer->phase, cosine) -
           layer.smooth * sum_of_moments(layer.moments, cosine);
}

double SingleScattering::operator()(double theta_i, double theta_o, double delta_phi) const
{
    const Direction in{n_above_, std::cos(theta_i)}, out{n_above_, std::cos(theta_o)};
    double n = n_above_, cosine_i = in.cosine, cosine_o = out.cosine, passes = 1, sum = 0;
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
            const double cosine = sines * std::cos(delta_phi) - cosine_i * cosine_o;
            sum += passes * std::pow(n_above_ / n, 2) * difference(scatterer, cosine) *
                   -std::expm1(-depth) / (scatterer.extinction * (cosine_i + cosine_o));
        }
        passes *= std::exp(-depth);
    }
    return sum;
}

}  // namespace gonio::reference

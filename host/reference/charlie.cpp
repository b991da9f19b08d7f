// SPDX-License-Identifier: Apache-2.0
// Estevez & Kulla, Production friendly microfacet sheen BRDF, SIGGRAPH course notes, 2017.
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

/// The fit to Smith's Lambda: a/(1 + b x^c) + d x + e, between coefficients for roughness 0 and 1
/// with the weight (1 - roughness)^2.
double fit(double roughness, double x)
{
    const double weight = (1 - roughness) * (1 - roughness);
    const auto mix = [weight](double smooth, double rough) {
        return weight * smooth + (1 - weight) * rough;
    };
    const double a = mix(25.3245, 21.5473), b = mix(3.32435, 3.82987), c = mix(0.16801, 0.19823);
    const double d = mix(-1.27393, -1.97760), e = mix(-4.85967, -4.32054);
    return a / (1 + b * std::pow(x, c)) + d * x + e;
}

double lambda(double roughness, double cos_theta)
{
    if (cos_theta < 0.5) return std::exp(fit(roughness, cos_theta));
    return std::exp(2 * fit(roughness, 0.5) - fit(roughness, 1 - cos_theta));
}

/// G/(4 (n.l)(n.v)); neubelt: Neubelt & Pettineo, Crafting a next-gen material pipeline for The
/// Order: 1886, SIGGRAPH course notes, 2013.
double visibility(const charlie_params& p, double cos_i, double cos_o)
{
    if (p.masking == charlie_masking::neubelt) return 1 / (4 * (cos_i + cos_o - cos_i * cos_o));
    const double masked = lambda(p.roughness, cos_i) + lambda(p.roughness, cos_o);
    return 1 / ((1 + masked) * 4 * cos_i * cos_o);
}

}  // namespace

/// c D V with D = (2 + 1/r) sin^(1/r) theta_h/(2 pi)
double charlie(const charlie_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const glm::dvec3 h = half_vector(l, v).h;
    const double sin2 = h.x * h.x + h.y * h.y, inverse = 1 / p.roughness;
    const double log_sin2 = sin2 < 0.5 ? std::log(sin2) : std::log1p(-h.z * h.z);
    const double d = (2 + inverse) * std::exp(inverse * log_sin2 / 2) / (2 * std::numbers::pi);
    return p.c[channel] * d * visibility(p, l.z, v.z);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Chandrasekhar, Radiative Transfer, Oxford 1950, sections 33 and 38.
#include "reference/chandrasekhar.hpp"

#include <cmath>
#include <numbers>

#include "reference/gauss_legendre.hpp"

namespace gonio::reference {
namespace {

using std::numbers::pi;

/// 1 - t cot t for t in [0, pi / 2], without cancellation.
double one_minus_t_cot_t(double t)
{
    const double s = t * t;
    if (t < 0.03) return s * (1.0 / 3 + s * (1.0 / 45 + s * (2.0 / 945 + s / 4725)));
    return 1 - t / std::tan(t);
}

}  // namespace

double chandrasekhar_h(double cosine, double albedo)
{
    // Stibbs and Weir, Mon. Not. R. Astron. Soc. 119, 1959: ln H = -(mu / pi) times the integral of
    // ln(1 - w t cot t) / (cos^2 t + mu^2 sin^2 t) over t from 0 to pi / 2. With mu tan t = tan psi
    // the denominator goes. What is left has a logarithm at psi = 0 (w = 1) and changes fast near
    // it (small mu), which the double exponential rule of Takahasi and Mori, Publ. RIMS 9, 1974,
    // resolves.
    constexpr double step = 1.0 / 32;
    constexpr int last = 128;
    double sum = 0;
    for (int i = -last; i <= last; ++i) {
        const double x = i * step;
        const double tail = std::exp(-pi * std::sinh(x));
        const double psi = pi / 2 / (1 + tail);
        const double weight = pi * std::cosh(x) * psi * tail / (1 + tail);
        const double t = std::atan2(std::sin(psi), cosine * std::cos(psi));
        sum += weight * std::log((1 - albedo) + albedo * one_minus_t_cot_t(t));
    }
    return std::exp(-sum * step / pi);
}

// Chandrasekhar 1950, section 33, eq. 6, divided by the incident flux.
double chandrasekhar_brdf(double cosine_i, double cosine_o, double albedo)
{
    return albedo / (4 * pi) * chandrasekhar_h(cosine_i, albedo) *
           chandrasekhar_h(cosine_o, albedo) / (cosine_i + cosine_o);
}

double chandrasekhar_plane_albedo(double cosine_i, double albedo)
{
    return 1 - chandrasekhar_h(cosine_i, albedo) * std::sqrt(1 - albedo);
}

double chandrasekhar_spherical_albedo(double albedo)
{
    const QuadratureRule rule = gauss_legendre(64);
    double sum = 0;
    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i) {
        const double cosine = rule.nodes(i);
        sum += rule.weights(i) * 2 * cosine * chandrasekhar_plane_albedo(cosine, albedo);
    }
    return sum;
}

}  // namespace gonio::reference

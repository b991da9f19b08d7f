// SPDX-License-Identifier: Apache-2.0
// He, Torrance, Sillion & Greenberg, A comprehensive physical model for light reflection, SIGGRAPH
// 1991: the directional-diffuse part.
#include <cmath>
#include <numbers>

#include "reference/facets.hpp"
#include "reference/params.hpp"
#include "reference/wave_series.hpp"

namespace gonio::reference {
namespace {

/// tau cot(theta)/(2 sigma_0)
double inverse_slope(const he_torrance_params& p, glm::dvec3 w)
{
    return p.tau * w.z / (2 * p.sigma * std::hypot(w.x, w.y));
}

/// Eqs. 24 and 25, with the factor exp(-(tau cot(theta)/(2 sigma_0))^2) that the print of Lambda
/// omits.
double shadowing(const he_torrance_params& p, glm::dvec3 w)
{
    const double a = inverse_slope(p, w);
    const double lambda =
        0.5 * (std::exp(-a * a) / (a * std::sqrt(std::numbers::pi)) - std::erfc(a));
    return (1 - 0.5 * std::erfc(a)) / (lambda + 1);
}

/// Eqs. 82 and 83: tan(theta) erfc(tau cot(theta)/(2 sigma_0))
double hidden(const he_torrance_params& p, glm::dvec3 w)
{
    return std::hypot(w.x, w.y) / w.z * std::erfc(inverse_slope(p, w));
}

/// The solution y of y e^y = z for z >= 0, by Newton's method from above.
double lambert_w(double z)
{
    double y = std::log1p(z);
    for (int i = 0; i < 20; ++i) y -= (y - z * std::exp(-y)) / (1 + y);
    return y;
}

/// Eqs. 80 and 81: sigma_0/sqrt(1 + x^2), where the parts of the surface that are neither lit nor
/// seen are left out: x e^(x^2/2) = (K_i + K_o)/sqrt(8 pi), so x^2 is Lambert's W of the square.
double effective_sigma(const he_torrance_params& p, glm::dvec3 l, glm::dvec3 v)
{
    const double k = hidden(p, l) + hidden(p, v);
    return p.sigma / std::sqrt(1 + lambert_w(k * k / (8 * std::numbers::pi)));
}

}  // namespace

/// Eqs. 76 to 79 for unpolarised light: F G S D/(pi (n.l)(n.v)) with
/// G = (|l + v|^2/(n.l + n.v))^2 and D = (pi tau/(2 lambda))^2 W(g, b).
double he_torrance(const he_torrance_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const auto [h, cos_d] = half_vector(l, v);
    const double geometry = cos_d / h.z;
    return facet_reflectance(p, cos_d, channel) * geometry * geometry / (l.z * v.z) *
           shadowing(p, l) * shadowing(p, v) *
           diffracted(p, effective_sigma(p, l, v), l.z + v.z, l, v);
}

/// The specular part: F e^-g S.
double he_torrance_specular(const he_torrance_params& p, glm::dvec3 l, std::size_t channel)
{
    return facet_reflectance(p, l.z, channel) * shadowing(p, l) * shadowing(p, l) *
           undiffracted(p, effective_sigma(p, l, l), 2 * l.z);
}

}  // namespace gonio::reference

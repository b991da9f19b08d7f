// SPDX-License-Identifier: Apache-2.0
// Oren & Nayar, Generalization of Lambert's reflectance model, SIGGRAPH 1994, and the forms without
// angles that follow it: Fujii 2012; Portsmouth, Kutz & Hill, EON, JCGT 2025.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/params.hpp"

namespace gonio::reference {
namespace {

using std::numbers::pi;

/// alpha and beta are the greater and the lesser of theta_i and theta_o. Tangents come from sines
/// and cosines: angles near 90 degrees have lost their digits.
struct Pair {
    double alpha, beta, cos_phi;
    double sin_alpha, tan_beta, tan_half_sum;
};

Pair pair_of(glm::dvec3 l, glm::dvec3 v)
{
    const double sin_i = std::hypot(l.x, l.y), sin_o = std::hypot(v.x, v.y);
    const auto [beta, alpha] = std::minmax({std::atan2(sin_i, l.z), std::atan2(sin_o, v.z)});
    return {alpha,
            beta,
            std::cos(std::atan2(v.y, v.x) - std::atan2(l.y, l.x)),
            std::max(sin_i, sin_o),
            std::min(sin_i / l.z, sin_o / v.z),
            (sin_i + sin_o) / (l.z + v.z)};
}

/// Oren & Nayar 1994, eq. 30: rho/pi (A + B max(0, cos phi) sin alpha tan beta).
double qualitative(double rho, double sigma, const Pair& at)
{
    const double sigma2 = sigma * sigma;
    const double a = 1 - 0.5 * sigma2 / (sigma2 + 0.33), b = 0.45 * sigma2 / (sigma2 + 0.09);
    return rho / pi * (a + b * std::max(0.0, at.cos_phi) * at.sin_alpha * at.tan_beta);
}

/// Oren & Nayar 1994, the fit with all terms: rho/pi (C1 + cos phi C2 tan beta + (1 - |cos phi|) C3
/// tan((alpha + beta)/2)) of direct light and 0.17 rho^2/pi ... of light reflected twice. Above 37
/// degrees the fit is negative where both graze on opposite sides: 0 there.
double full(double rho, double sigma, const Pair& at)
{
    const double sigma2 = sigma * sigma, part = 2 * at.beta / pi;
    const double c1 = 1 - 0.5 * sigma2 / (sigma2 + 0.33);
    const double c2 = 0.45 * sigma2 / (sigma2 + 0.09) *
                      (at.sin_alpha - (at.cos_phi < 0 ? part * part * part : 0));
    const double c3 =
        0.125 * sigma2 / (sigma2 + 0.09) * std::pow(4 * at.alpha * at.beta / (pi * pi), 2);
    const double once =
        c1 + at.cos_phi * c2 * at.tan_beta + (1 - std::abs(at.cos_phi)) * c3 * at.tan_half_sum;
    const double twice = 0.17 * sigma2 / (sigma2 + 0.13) * (1 - at.cos_phi * part * part);
    return std::max(0.0, rho / pi * once + rho * rho / pi * twice);
}

constexpr double half_minus = 0.5 - 2 / (3 * pi);

/// Portsmouth et al. 2025: A = 1/(1 + (1/2 - 2/(3 pi)) r), B = r A, f = rho/pi (A + B s/t) with
/// s = l.v - (n.l)(n.v) and t = max(n.l, n.v) where s > 0, else 1. Where 1 + r s cancels, 1 + s is
/// half of |l + v|^2 without 2 (n.l)(n.v).
double fujii(double rho, double r, glm::dvec3 l, glm::dvec3 v)
{
    const double a = 1 / (1 + half_minus * r), s = l.x * v.x + l.y * v.y;
    const double x = l.x + v.x, y = l.y + v.y;
    const double one_plus_s = (x * x + y * y + l.z * l.z + v.z * v.z) / 2;
    return rho / pi * a * (s > 0 ? 1 + r * s / std::max(l.z, v.z) : 1 - r + r * one_plus_s);
}

/// (1 - E)/(A r) with E = A + B G/pi the albedo of fujii for rho = 1. In G = sin (theta - sin cos)
/// + 2/3 (tan (1 - sin^3) - sin), tan (1 - sin^3) is sin cos (1 + sin + sin^2)/(1 + sin).
double missing_energy(glm::dvec3 w)
{
    const double sin = std::hypot(w.x, w.y), theta = std::atan2(sin, w.z);
    const double g =
        sin * (theta - sin * w.z) + 2.0 / 3 * (sin * w.z * (1 + sin + sin * sin) / (1 + sin) - sin);
    return half_minus - g / pi;
}

/// Portsmouth et al. 2025: fujii plus rho_ms/pi (1 - E_i)(1 - E_o)/(1 - E_mean) with
/// rho_ms = rho^2 E_mean/(1 - rho (1 - E_mean)) and E_mean = A (1 + (2/3 - 28/(15 pi)) r).
double eon(double rho, double r, glm::dvec3 l, glm::dvec3 v)
{
    constexpr double mean_rise = 2.0 / 3 - 28 / (15 * pi);
    const double a = 1 / (1 + half_minus * r), mean = a * (1 + mean_rise * r);
    const double rho_ms = rho * rho * mean / (1 - rho * (1 - mean));
    return fujii(rho, r, l, v) +
           rho_ms / pi * a * r * missing_energy(l) * missing_energy(v) / (half_minus - mean_rise);
}

}  // namespace

double oren_nayar(const oren_nayar_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const double rho = p.rho[channel];
    switch (p.form) {
        case oren_nayar_form::full:
            return full(rho, p.sigma, pair_of(l, v));
        case oren_nayar_form::fujii:
            return fujii(rho, p.roughness, l, v);
        case oren_nayar_form::eon:
            return eon(rho, p.roughness, l, v);
        case oren_nayar_form::qualitative:
            break;
    }
    return qualitative(rho, p.sigma, pair_of(l, v));
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Torrance & Sparrow, JOSA 57, 1967, in the form of Walter et al., Microfacet models for
// refraction, EGSR 2007.
#include <cmath>
#include <numbers>

#include "reference/facets.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

/// Trowbridge & Reitz, JOSA 65, 1975; the anisotropic form of Burley 2012, eq. 13.
double ggx(const torrance_sparrow_params& p, glm::dvec3 h)
{
    const double x = h.x / p.alpha_x, y = h.y / p.alpha_y;
    const double q = x * x + y * y + h.z * h.z;
    return 1 / (std::numbers::pi * p.alpha_x * p.alpha_y * q * q);
}

/// Beckmann & Spizzichino 1963.
double beckmann(const torrance_sparrow_params& p, glm::dvec3 h)
{
    const double x = h.x / p.alpha_x, y = h.y / p.alpha_y;
    return std::exp(-(x * x + y * y) / (h.z * h.z)) /
           (std::numbers::pi * p.alpha_x * p.alpha_y * std::pow(h.z, 4));
}

/// Smith's Lambda (Heitz, JCGT 3(2), 2014, eqs. 72 and 66 with the exact erfc), 1/a = alpha tan
/// theta along w.
double lambda(const torrance_sparrow_params& p, glm::dvec3 w)
{
    const double projected = std::hypot(p.alpha_x * w.x, p.alpha_y * w.y);
    if (projected == 0) return 0;
    const double a = w.z / projected;
    if (p.ndf == torrance_sparrow_ndf::ggx) return 0.5 * (std::sqrt(1 + 1 / (a * a)) - 1);
    return 0.5 * (std::exp(-a * a) / (a * std::sqrt(std::numbers::pi)) - std::erfc(a));
}

double masking(const torrance_sparrow_params& p, glm::dvec3 l, glm::dvec3 v, const Half& half)
{
    if (p.masking == torrance_sparrow_masking::v_cavity) return v_cavity(l, v, half);
    const double lambda_l = lambda(p, l), lambda_v = lambda(p, v);
    if (p.masking == torrance_sparrow_masking::separable)
        return 1 / ((1 + lambda_l) * (1 + lambda_v));
    return 1 / (1 + lambda_l + lambda_v);
}

}  // namespace

/// F D G/(4 (n.l)(n.v)): Walter et al. 2007, eq. 20.
double torrance_sparrow(const torrance_sparrow_params& p, glm::dvec3 l, glm::dvec3 v,
                        std::size_t channel)
{
    const Half half = half_vector(l, v);
    const double d = p.ndf == torrance_sparrow_ndf::ggx ? ggx(p, half.h) : beckmann(p, half.h);
    return facet_reflectance(p, half.cos_d, channel) * d * masking(p, l, v, half) / (4 * l.z * v.z);
}

}  // namespace gonio::reference

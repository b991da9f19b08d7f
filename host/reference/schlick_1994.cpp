// SPDX-License-Identifier: Apache-2.0
// Schlick, An inexpensive BRDF model for physically-based rendering, CGF 13(3), 1994.
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/fresnel.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

double arithmetic_geometric_mean(double a, double b)
{
    while (std::abs(a - b) > 1e-15 * a) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

/// A(w) = sqrt(p/(p^2 - p^2 w^2 + w^2)), w the cosine between the tangent x and the projection of
/// h. Its mean over all azimuths is sqrt(p)/agm(1, p).
double azimuth_factor(const schlick_1994_params& p, glm::dvec3 h)
{
    const double iso = p.isotropy, sin2 = h.x * h.x + h.y * h.y;
    // h = n has no azimuth; rounding would give it one.
    const double w2 = sin2 < 1e-12 ? 0 : h.x * h.x / sin2;
    const double printed = std::sqrt(iso / (iso * iso * (1 - w2) + w2));
    if (p.azimuth == schlick_1994_azimuth::printed) return printed;
    return printed * arithmetic_geometric_mean(1, iso) / std::sqrt(iso);
}

/// G(x)/x with G(x) = x/(r - r x + x), or 1/x
double masking_over_cosine(const schlick_1994_params& p, Cosine x)
{
    if (p.masking == schlick_1994_masking::none) return 1 / x.value;
    return 1 / (p.roughness * x.one_minus + x.value);
}

}  // namespace

/// S(u) G(n.l) G(n.v) Z(t) A(w)/(4 pi (n.l)(n.v)) with Z(t) = r/(1 + r t^2 - t^2)^2, t = n.h.
double schlick_1994(const schlick_1994_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const auto [h, cos_d] = half_vector(l, v);
    const double below = h.x * h.x + h.y * h.y + p.roughness * h.z * h.z;
    const double z = p.roughness / (below * below);
    return fresnel_schlick(p.f0[channel], cos_d) * z * azimuth_factor(p, h) *
           masking_over_cosine(p, cosine_to_normal(l)) *
           masking_over_cosine(p, cosine_to_normal(v)) / (4 * std::numbers::pi);
}

}  // namespace gonio::reference

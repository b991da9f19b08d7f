// SPDX-License-Identifier: Apache-2.0
// Ashikhmin & Shirley, An anisotropic Phong BRDF model, JGT 5(2), 2000.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/fresnel.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

/// sqrt((n_u + 1)(n_v + 1))/(8 pi) (n.h)^e F(k.h)/((k.h) max(n.l, n.v)) with the exponent
/// e = (n_u h.x^2 + n_v h.y^2)/(1 - (n.h)^2).
double specular(const ashikhmin_shirley_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const auto [h, cos_d] = half_vector(l, v);
    const double x2 = h.x * h.x, y2 = h.y * h.y;
    const double exponent = x2 + y2 > 0 ? (p.n_u * x2 + p.n_v * y2) / (x2 + y2) : p.n_u;
    const double norm = std::sqrt((p.n_u + 1) * (p.n_v + 1)) / (8 * std::numbers::pi);
    return norm * power(cosine_to_normal(h), exponent) * fresnel_schlick(p.r_s[channel], cos_d) /
           (cos_d * std::max(l.z, v.z));
}

/// 1 - (1 - cos/2)^5
double entering(double cos_theta)
{
    return -std::expm1(5 * std::log1p(-cos_theta / 2));
}

}  // namespace

/// The specular lobe and the diffuse one, 28 R_d (1 - R_s)/(23 pi) (1 - (1 - n.l/2)^5)
/// (1 - (1 - n.v/2)^5).
double ashikhmin_shirley(const ashikhmin_shirley_params& p, glm::dvec3 l, glm::dvec3 v,
                         std::size_t channel)
{
    const double diffuse = 28 * p.r_d[channel] * (1 - p.r_s[channel]) / (23 * std::numbers::pi) *
                           entering(l.z) * entering(v.z);
    return specular(p, l, v, channel) + diffuse;
}

}  // namespace gonio::reference

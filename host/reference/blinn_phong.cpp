// SPDX-License-Identifier: Apache-2.0
// Blinn, Models of light reflection for computer synthesized pictures, SIGGRAPH 1977.
#include <cmath>
#include <numbers>

#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

/// exact: the inverse of the integral of (n.h)^n cos theta_o over the hemisphere at normal
/// incidence. norm8: Akenine-Moeller, Haines & Hoffman, Real-Time Rendering, 3rd ed., 2008, 7.6.
double norm_of(blinn_phong_form form, double n)
{
    using std::numbers::pi;
    if (form == blinn_phong_form::exact)
        return (n + 2) * (n + 4) / (8 * pi * (n + std::exp2(-n / 2)));
    return form == blinn_phong_form::norm8 ? (n + 8) / (8 * pi) : 1;
}

}  // namespace

/// rho_s (n.h)^n times the norm of the form
double blinn_phong(const blinn_phong_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const Cosine n_h = cosine_to_normal(half_vector(l, v).h);
    return p.rho_s[channel] * norm_of(p.form, p.exponent) * power(n_h, p.exponent);
}

}  // namespace gonio::reference

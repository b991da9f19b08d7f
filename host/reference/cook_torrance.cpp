// SPDX-License-Identifier: Apache-2.0
// Cook & Torrance, A reflectance model for computer graphics, ACM TOG 1(1), 1982, and its
// misprints.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/facets.hpp"
#include "reference/params.hpp"

namespace gonio::reference {
namespace {

/// What multiplies F exp(...)/(m^2 cos^4 delta) G/((n.l)(n.v)). The print has the 4 of the modern
/// form inside of D and no pi.
double factor(cook_torrance_form form)
{
    using std::numbers::pi;
    switch (form) {
        case cook_torrance_form::modern:
            return 1 / (4 * pi);
        case cook_torrance_form::cook_torrance_1982:
            return 1 / pi;
        case cook_torrance_form::as_printed:
        case cook_torrance_form::printed_repaired:
            break;
    }
    return 1.0 / 4;
}

}  // namespace

/// Cook & Torrance 1982: F D G/(pi (n.l)(n.v)), D = exp(-(tan(delta)/m)^2)/(m^2 cos^4 delta); the
/// modern form is that of Walter et al., EGSR 2007, eq. 20. As printed, the exponent is
/// -tan(delta)/m^2, and the fractions in G are over n.h, which leaves 2 n.v and 2 n.l.
double cook_torrance(const cook_torrance_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const Half half = half_vector(l, v);
    const double tan2 = tangent2(half.h), m2 = p.m * p.m;
    const bool as_printed = p.form == cook_torrance_form::as_printed;
    const double exponent = as_printed ? std::sqrt(tan2) / m2 : tan2 / m2;
    const double d = std::exp(-exponent) / (m2 * std::pow(half.h.z, 4));
    const double g = as_printed ? std::min({1.0, 2 * v.z, 2 * l.z}) : v_cavity(l, v, half);
    return facet_reflectance(p, half.cos_d, channel) * d * g * factor(p.form) / (l.z * v.z);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Schlick, A fast alternative to Phong's specular model, Graphics Gems IV, 1994.
#include "reference/cosine.hpp"
#include "reference/params.hpp"

namespace gonio::reference {

/// The value t/(n - n t + t) with t = r.v or n.h; 0 where t <= 0.
double schlick(const schlick_params& p, glm::dvec3 l, glm::dvec3 v, std::size_t channel)
{
    const Cosine t = p.argument == schlick_argument::r_dot_v
                         ? cosine_to_mirror(l, v)
                         : cosine_to_normal(half_vector(l, v).h);
    if (t.value <= 0) return 0;
    return p.k_s[channel] * t.value / (p.exponent * t.one_minus + t.value);
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// What the references of rough surfaces share: the facet's reflectance as FACET_FRESNEL of the
// registry declares it, and grooves that mask each other.
#pragma once

#include <algorithm>
#include <cstddef>

#include "reference/cosine.hpp"
#include "reference/fresnel.hpp"

namespace gonio::reference {

/// Params has the members fresnel, f0, eta, k.
template <class Params>
double facet_reflectance(const Params& p, double cos_theta, std::size_t channel)
{
    using Fresnel = decltype(p.fresnel);
    if (p.fresnel == Fresnel::schlick) return fresnel_schlick(p.f0[channel], cos_theta);
    return fresnel_exact(p.eta[channel], p.fresnel == Fresnel::conductor ? p.k[channel] : 0,
                         cos_theta);
}

/// Masking by V-shaped grooves: Torrance & Sparrow 1967 in the form of Blinn, SIGGRAPH 1977.
inline double v_cavity(glm::dvec3 l, glm::dvec3 v, const Half& half)
{
    return std::min(1.0, 2 * half.h.z * std::min(l.z, v.z) / half.cos_d);
}

}  // namespace gonio::reference

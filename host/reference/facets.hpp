// SPDX-License-Identifier: Apache-2.0
// What the microfacet references share: the facet's reflectance as FACET_FRESNEL of the registry
// declares it.
#pragma once

#include <cstddef>

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

}  // namespace gonio::reference

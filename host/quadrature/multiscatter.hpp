// SPDX-License-Identifier: Apache-2.0
// What facets scatter more than once.
#pragma once

#include "gonio/albedo.hpp"
#include "gonio/job.hpp"

namespace gonio {

/// Kulla & Conty, Revisiting physically based shading at Imageworks, SIGGRAPH course notes, 2017:
/// F_ms (1 - E(mu_i)) (1 - E(mu_o))/(pi (1 - E_mean)) with F_ms = F^2 E_mean/(1 - F (1 - E_mean)),
/// E and its mean for facets that reflect all light and F the mean reflectance of a facet.
Albedos multiscatter_lobe(const Device& device, const Job& job);

/// The same facets, reflecting all light.
Material white_facets(const Material& material);

/// 2 times the integral of a facet's reflectance times mu over mu.
double mean_reflectance(const Lobe& lobe, std::size_t channel);

}  // namespace gonio

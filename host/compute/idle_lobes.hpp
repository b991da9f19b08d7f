// SPDX-License-Identifier: Apache-2.0
// Lobes that add nothing, and facets that reflect the same in every direction.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gonio/material.hpp"

namespace gonio {

/// What the facets of a lobe reflect, if that depends neither on direction nor on channel: 1 with
/// Schlick's f0 = 1, 0 between equal refractive indices. Nothing for lobes without facets.
std::optional<double> even_facet_reflectance(const Lobe& lobe);

/// Does the lobe add nothing: is its weight 0, or has it no reflectance, in every channel?
bool is_idle(const Lobe& lobe);

/// The material without its idle lobes, with the same channels; a Lambertian surface of weight 0
/// where no lobe is left.
Material without_idle_lobes(const Material& material);

/// Which lobes of materials that have the same ones are not idle in all of them.
std::vector<std::size_t> lobes_with_light(const std::vector<Material>& materials);

}  // namespace gonio

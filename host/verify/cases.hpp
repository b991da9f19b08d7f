// SPDX-License-Identifier: Apache-2.0
// What a model is verified on: parameters and directions, random and extreme. The same every time.
#pragma once

#include <string>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/material.hpp"

namespace gonio {

/// The model with its defaults and, for each other option of each choice, with that one chosen.
std::vector<Lobe> single_variants(const Model& model);

/// With the defaults of numbers, every combination of options.
std::vector<Lobe> all_variants(const Model& model);

/// A residual of noise, -1 to 1, for parameters of kind TABLE.
std::shared_ptr<const ResidualGrid> verification_residual(Spacing spacing, std::size_t channels);

/// Every combination of options (quick: every option), each with the defaults, every parameter at
/// both ends of its range, and random sets.
std::vector<Material> verification_materials(const Model& model, bool quick);

/// Angles from exactly normal to cos theta = 1e-6, pairs at the mirror direction, next to it and at
/// retro-reflection, and `count` random ones, on a grid that fits the material.
Grid verification_grid(const Material& material, std::size_t count);

/// Half vectors from 1e-6 degrees to grazing.
Grid verification_half_grid(std::size_t count);

/// The same kinds of pairs as a list.
std::vector<DirectionPair> verification_pairs(std::size_t count);

/// "form = ward_1992, alpha_x = 1e-05, ..."
std::string parameter_text(const Lobe& lobe);

}  // namespace gonio

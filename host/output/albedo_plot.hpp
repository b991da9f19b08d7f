// SPDX-License-Identifier: Apache-2.0
// The curve of the directional albedo with its axes.
#pragma once

#include <span>

#include "output/albedo_curve.hpp"
#include "output/canvas.hpp"

namespace gonio {

/// Albedo against theta_i in `box`, axes and labels included; a line for each of up to three
/// channels. The axis ends at 1, or at the largest albedo up to 2: what is larger is told in words.
void draw_albedo(cairo_t* cairo, std::span<const AlbedoPoint> curve, const Box& box);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The lobe in the plane of incidence: which pairs of directions it needs, and its polar plot.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "gonio/grid.hpp"
#include "output/canvas.hpp"

namespace gonio {

/// The plane of incidence along x from horizon to horizon, for light theta_i degrees from the
/// normal.
std::vector<DirectionPair> lobe_pairs(double theta_i);

/// The height that a plot needs for a width: a half disc, and its labels below.
double lobe_plot_height(double width);

/// brdf[k] belongs to lobe_pairs(theta_i)[k], linear sRGB, in 1/sr. The radius is the cube root of
/// the BRDF, which keeps a diffuse base visible under a highlight; rings are decades. (x, y) is the
/// upper left corner.
void draw_lobe(cairo_t* cairo, std::span<const glm::vec3> brdf, double theta_i, double x, double y,
               double width);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Where an integral over the hemisphere has its nodes: lines of nodes at azimuths, made in double.
#pragma once

#include <vector>

#include "gonio/albedo.hpp"
#include "gonio/shared/quadrature_fields.h"

namespace gonio {

/// How slopes of half vectors spread along x and y: a node's slope there is this times sinh of the
/// radial variable.
struct Spread {
    double x = 1, y = 1;
};

/// A line of radial nodes at one azimuth from the plane of incidence, as node_field names it.
struct AzimuthNode {
    double cosine, sine, frame_cosine, frame_sine, scale, from, span, end, weight;
};

/// What the integrand is like.
struct Smoothness {
    bool isotropic = true;  ///< even in the azimuth from the plane of incidence
    bool kinks = false;     ///< see KINKED of gonio/model.hpp
};

/// Lines of nodes with about `order` azimuths; each is to be divided by a rule of the same order.
/// Panels end at kinks, and nodes crowd where the integrand is all but singular: across the plane
/// of incidence at grazing angles, and along the ridge of a brushed surface.
std::vector<AzimuthNode> azimuth_nodes(quadrature_map map, const Incidence& at,
                                       const Spread& spread, const Smoothness& smoothness,
                                       int order);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Smooth boundaries between media, and light that meets nothing else.
#pragma once

#include <Eigen/Core>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/directions.hpp"

namespace gonio::reference {

/// Fractions of unpolarised light that a smooth boundary, or many, send back and let through in
/// each direction.
struct Interface {
    Eigen::ArrayXd reflected;
    Eigen::ArrayXd transmitted;
};

/// Fresnel's equations, the same from both sides. Total reflection for a direction that exists on
/// one side only.
Interface fresnel_interface(const Directions& directions, double n_1, double n_2);

/// Below the last layer: the open bottom, the mirror, or nothing that keeps light in its direction.
Interface bottom_interface(const LayeredMedium& medium, const Directions& directions);

/// Light from above that is never scattered, through all boundaries and with all round trips.
Interface follow_unscattered(const LayeredMedium& medium, const Directions& directions);

/// What MCML calls specular: reflection before light meets anything that absorbs or scatters. That
/// is the first boundary, and with the second one where the first layer is clear (mua = mus = 0).
Eigen::ArrayXd specular_reflectance(const LayeredMedium& medium, const Directions& directions);

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Directional albedo by products of Gauss rules, for tests of closed forms and tables.
#pragma once

#include "reference/reference_fixtures.hpp"

namespace gonio {

/// The integral of f cos theta_o over all v for light at n.l = mu, of an isotropic lobe that is
/// even in azimuth; in panels that end where models have kinks: theta_o = theta_i, 90 degrees of
/// azimuth.
double albedo(const Brdf& f, double mu, int nodes);

/// The same over half vectors, in slopes stretched by alpha, for narrow lobes around h = n.
double albedo_over_half_vectors(const Brdf& f, double mu, double alpha, int nodes);

/// 2 times the integral of E mu over mu, with nodes that crowd at mu = 0.
double mean_albedo(const std::function<double(double mu)>& directional, int nodes);

}  // namespace gonio

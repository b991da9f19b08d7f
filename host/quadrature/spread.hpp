// SPDX-License-Identifier: Apache-2.0
// How wide a lobe is.
#pragma once

#include "gonio/material.hpp"
#include "quadrature/nodes.hpp"

namespace gonio {

/// Measured on the reference at normal incidence: the slopes of half vectors along x and along y
/// within which a fifth of the reflected light lies; the least of all channels.
Spread spread_of(const Material& material);

}  // namespace gonio

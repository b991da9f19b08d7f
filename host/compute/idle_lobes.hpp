// SPDX-License-Identifier: Apache-2.0
// Lobes that add nothing.
#pragma once

#include "gonio/material.hpp"

namespace gonio {

/// The material without the lobes whose weights are all 0, where it keeps its channels and at least
/// one lobe.
Material without_idle_lobes(const Material& material);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The medium of the benchmarks of light in layers.
#pragma once

#include "gonio/layers.hpp"
#include "reference/adding_doubling.hpp"

namespace gonio {

/// meglinski_2002 at 633 nm: seven layers.
LayeredMedium benchmark_skin();

/// Where a pencil beam ends, to about 1e-9, by adding-doubling.
reference::LightBudget exact_light(const LayeredMedium& medium);

}  // namespace gonio

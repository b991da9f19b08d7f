// SPDX-License-Identifier: Apache-2.0
// The layers that a table needs.
#pragma once

#include <cstddef>

#include "gonio/job.hpp"

namespace gonio {

/// A medium without what its table does not need.
struct AskedLayers {
    LayeredMedium medium;
    std::size_t clear = 0;      ///< layers that only pass light on
    std::size_t unreached = 0;  ///< those below a layer that now has no end
    /// The largest part of the light that would come as far as those and back.
    double returned = 0;
};

/// Of a job with layers. Clear layers of their neighbour's index go where nothing tells distances,
/// times or layers. Deep ones go where reflected light is asked for with a max_error, if what could
/// return from them changes no value by a tenth of that.
AskedLayers asked_layers(const Job& job);

}  // namespace gonio

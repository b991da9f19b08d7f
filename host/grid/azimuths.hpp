// SPDX-License-Identifier: Apache-2.0
// How far an axis of azimuths goes.
#pragma once

#include "gonio/table.hpp"

namespace gonio {

/// Azimuths of cells that begin at 0 end at 360 degrees, and not at 180.
inline bool covers_whole_turn(const Axis& centres)
{
    return centres.values.front() + centres.values.back() > 270;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// A table's layout in words: which texel is which sample. EXR headers and `gonio info` say it.
#pragma once

#include <string>

#include "gonio/table.hpp"

namespace gonio {

/// "90 cell centres, evenly spaced from 0.5 to 89.5 degree"; with all values if they are uneven.
std::string axis_text(const Axis& axis);

/// "theta_i (outer), theta_o": the axes that an image's rows run through, swept ones left out.
std::string rows_text(const TableHeader& header);

/// "delta_phi": the axis that an image's columns run through.
std::string columns_text(const TableHeader& header);

/// How to get from an axis to a texel coordinate.
std::string texels_text(const TableHeader& header);

/// Is the axis a + k * step to within rounding?
bool is_evenly_spaced(const Axis& axis);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Is this header one that every format can hold?
#pragma once

#include <string>

#include "gonio/table.hpp"

namespace gonio {

/// Throws a UsageError that names the first fault: an empty, unsorted or nameless axis, two axes or
/// channels of one name, no channel, a number that is not finite, more cells than can be addressed.
void check(const TableHeader& header);

/// "90 x 90 x 180"; empty for a table without axes.
std::string shape_text(const TableHeader& header);

}  // namespace gonio

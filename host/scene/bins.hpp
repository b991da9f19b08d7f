// SPDX-License-Identifier: Apache-2.0
// The axes of a table as its quantity needs them.
#pragma once

#include "scene/reader.hpp"

namespace gonio {

/// Gives the request's axes their units. Throws UsageError at `axes` unless they are the
/// quantity's, in its order.
void name_axes(const Value& axes, TableRequest& request);

/// The same for the key `axes` of a table, whose axes must be even bins from 0 on, angles to 90
/// degrees, except wavelengths. Throws UsageError too where a quantity without axes has some.
void read_bins(const Section& table, TableRequest& request);

}  // namespace gonio

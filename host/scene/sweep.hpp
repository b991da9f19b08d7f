// SPDX-License-Identifier: Apache-2.0
// Parameters of a material in a scene: one value, or several as a sweep.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/reader.hpp"

namespace gonio {

/// Most values that one sweep or one axis can have.
inline constexpr std::size_t max_samples = 65536;

/// { from, to, count, spacing = "linear" | "log", as = "axis" | "files" } or { values = [...], as
/// }. Ends of a range are among its values.
Sweep read_sweep(const Value& value, std::size_t part);

/// A number, or a sweep, which is added to `sweeps`; returns the number or the sweep's first value.
double read_swept_number(const Value& value, std::size_t part, std::vector<Sweep>& sweeps);

}  // namespace gonio

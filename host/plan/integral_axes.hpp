// SPDX-License-Identifier: Apache-2.0
// What the axes of an integral over the hemisphere mean.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

/// A direction's cosine, angle or azimuth, or the cosine of the second direction.
enum class DirectionAxis { cosine, angle, azimuth, other_cosine };

/// The names that directions of this quantity can have as axes. Where there is a mu there may be
/// its angle instead, and an azimuth besides.
std::vector<std::pair<std::string_view, DirectionAxis>> direction_axes(const Quantity& quantity);

/// A number of a material by the name that headers give it ("alpha", "ward.alpha"); empty if there
/// is none.
std::optional<Sweep> parameter_of(const std::vector<Lobe>& lobes, std::string_view name);

/// Makes the job's materials, one for each combination of the parameters among the sweeps and the
/// axes, and its cells in row-major order of all axes.
void fill_integral(Job& job, const TableRequest& request, const std::vector<Lobe>& lobes,
                   const std::vector<Sweep>& sweeps);

}  // namespace gonio

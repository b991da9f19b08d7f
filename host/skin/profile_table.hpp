// SPDX-License-Identifier: Apache-2.0
// Tables of the light that spreads in skin.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/job.hpp"

namespace gonio {

/// The rings and photons that a request needs; where it says nothing, the defaults.
ProfileRequest profile_request(const TableRequest& request);

/// Axes: the ladders, then the request's. Channels: R, G, B, or Y of a spectrum, and for R(r) the
/// standard error of each.
TableHeader profile_header(const SkinTask& task, const TableRequest& request);

/// Follows the photons of all sets and writes the file; `after_each` gets the part that is done.
/// Returns what belongs beside it: the functions fitted to each set, in mm; of a spectrum how many
/// photons its wavelengths have seen.
nlohmann::ordered_json make_profile_table(const Device& device, const Job& job,
                                          const std::function<void(double)>& after_each);

}  // namespace gonio

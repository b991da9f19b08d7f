// SPDX-License-Identifier: Apache-2.0
// Tables of the spectrum that skin returns at each distance from a beam.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/job.hpp"

namespace gonio {

/// As make_profile_table(). Throws RunError where the photons were too few for a max_error that
/// must be reached.
nlohmann::ordered_json make_radial_table(const Device& device, const Job& job,
                                         const std::function<void(double)>& after_each);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Jobs of skin.
#pragma once

#include <string>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

/// Sets job.skin and job.header; the job knows its storage. `axes`: the sweeps that are axes.
void fill_skin(Job& job, const TableRequest& request, const std::string& material, const Skin& skin,
               const std::vector<Sweep>& axes);

}  // namespace gonio

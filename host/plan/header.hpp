// SPDX-License-Identifier: Apache-2.0
// The header of a planned table: all that determines its bytes, and what a reader must know.
#pragma once

#include <string>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

/// Everything about a job's storage that changes the bytes of its file.
std::string storage_text(const Job& job);

/// The header of a job that has everything else. `swept` are its sweeps that are axes.
TableHeader make_header(const Job& job, const TableRequest& request,
                        const std::vector<Sweep>& swept);

/// The header of a job with layers, which has a name for its material and the table's axes.
TableHeader make_light_header(const Job& job, const std::string& material,
                              const std::vector<Axis>& axes);

}  // namespace gonio

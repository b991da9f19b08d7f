// SPDX-License-Identifier: Apache-2.0
// What jobs will cost: cells, bytes, memory, time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

struct Estimate {
    std::uint64_t values = 0;        ///< cells times channels
    std::uint64_t file_bytes = 0;    ///< before compression
    std::uint64_t memory_bytes = 0;  ///< held by the host while the table is computed
    double seconds = 0;              ///< nan where only a solver can tell
};

/// values_per_second: as measured on the device.
Estimate estimate(const Job& job, double values_per_second);
std::vector<Estimate> estimates(const std::vector<Job>& jobs, double values_per_second);

/// A line for each job and one for the sum: what --dry-run prints.
std::string estimate_text(const std::vector<Job>& jobs, const std::vector<Estimate>& costs);

/// Throws UsageError if the files of these jobs together are larger than what is free where they
/// go.
void check_disk(const std::vector<Job>& jobs);

}  // namespace gonio

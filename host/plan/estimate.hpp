// SPDX-License-Identifier: Apache-2.0
// How large the tables of jobs will be, and whether there is room for them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gonio/job.hpp"
#include "plan/forecast.hpp"

namespace gonio {

struct TableSize {
    std::uint64_t values = 0;        ///< cells times channels
    std::uint64_t file_bytes = 0;    ///< before compression
    std::uint64_t memory_bytes = 0;  ///< held by the host while the table is computed
};

TableSize size_of(const Job& job);

/// A line for each job and one for the sum: what --dry-run prints.
std::string estimate_text(const std::vector<Job>& jobs, const std::vector<Forecast>& forecasts);

/// "interpolation is off by 0.01 of the largest value, 0.02 is asked"; empty where a grid was
/// given.
std::string interpolation_text(const Job& job);

/// "16.7 MiB"
std::string size_text(double bytes);

/// "0.3 s"
std::string time_text(double seconds);

/// Throws UsageError if the files of these jobs together are larger than what is free where they
/// go.
void check_disk(const std::vector<Job>& jobs);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job with layers: by adding-doubling, or by Monte Carlo until a budget ends.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "gonio/device.hpp"
#include "gonio/job.hpp"

namespace gonio {

/// How far a table is, for the line of progress.
struct LightProgress {
    double fraction = 0;  ///< of the work, as far as it can be told
    double photons_per_second = 0;
    double error = 0;  ///< the largest standard error, over the largest value
};

/// What happened to one job, for summaries.
struct LightTable {
    std::uint64_t photons = 0;  ///< 0 for adding-doubling
    double photons_per_second = 0;
    double error = 0;  ///< the largest; infinite where no light has come to tell it
    std::string error_of = "the largest value";  ///< what the error is a part of
    nlohmann::ordered_json run;
};

/// Writes the table to job.path; nothing is visible there unless it is complete. after_launch may
/// throw; without photons it is told the fraction alone. Throws RunError where the
/// budget ended before a max_error that must be reached. leave_out: layers that the table does not
/// need, as asked_layers() says.
LightTable make_light_table(const Device& device, const Job& job,
                            const std::function<void(const LightProgress&)>& after_launch,
                            bool leave_out = true);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Makes the table of a job: computes, checks against the reference, writes.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "gonio/compute.hpp"
#include "gonio/job.hpp"
#include "verify/accuracy.hpp"

namespace gonio {

/// What integrals took: the highest order of a rule, evaluations of the BRDF, and how many cells
/// were compared with the reference.
struct IntegralReport {
    int order = 0;
    std::size_t evaluated = 0, checked = 0;
};

/// What happened to one job, for summaries.
struct MadeTable {
    std::size_t cells = 0;                    ///< cells times sweep points
    std::optional<IntegralReport> integrals;  ///< then accuracy.relative is their largest error
    double kernel_seconds = 0;
    double checking_seconds = 0;  ///< on all cores, where a grid is compared with the reference
    double store_fraction = 0;  ///< of the rate at which the device writes the same number of bytes
    ComputeReport report;       ///< of the last sweep point
    Accuracy accuracy;
};

/// Streams the table to job.path; nothing is visible there unless it is complete and right.
/// after_rows: called with the number of cells that are done since the last call; may throw. Throws
/// CheckFailed if the device disagrees with the reference.
MadeTable make_table(const Device& device, const Job& job,
                     const std::function<void(std::size_t)>& after_rows,
                     const ComputeOptions& options = {});

/// The "run" of the sidecar: device, driver, timings, accuracy.
nlohmann::ordered_json run_information(const Device& device, const MadeTable& made);

}  // namespace gonio

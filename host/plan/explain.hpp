// SPDX-License-Identifier: Apache-2.0
// What a job will do, and what it leaves out because its table does not need it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compute/tiling.hpp"
#include "gonio/device.hpp"
#include "gonio/job.hpp"

namespace gonio {

struct LeftOut {
    std::string what, why;
    /// How many times the work there would be with it, about; unknown where it is only memory, time
    /// to build, or a matter of luck.
    std::optional<double> saving;
};

struct JobPlan {
    std::string solver;
    std::string kernel;                    ///< file of the program, empty without one
    std::vector<std::string> definitions;  ///< "NAME=VALUE"
    unsigned width = 1;
    std::optional<Tiling> tiling = {};  ///< of a grid
    std::size_t tally_bytes = 0;        ///< of photons, on the device
    bool finished = false;              ///< by an earlier run
    std::vector<LeftOut> left_out;
};

JobPlan explain(const Device& device, const Job& job);

}  // namespace gonio

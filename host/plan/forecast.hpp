// SPDX-License-Identifier: Apache-2.0
// What jobs will cost, and how exact they will be: told by making a small part of each.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/job.hpp"
#include "gonio/picture.hpp"

namespace gonio {

/// What the error of an integral is a part of.
inline constexpr auto integral_error_of = "each value, or of 1 where that is more";

struct Forecast {
    /// Without what the driver takes to build programs that it has not built before; nan where
    /// nothing tells.
    double seconds = 0;
    double error = NAN;         ///< nan as well
    std::string error_of = {};  ///< what it is a part of: "the largest value"
    bool is_bound = true;       ///< of the error, which else is about that
    double photons = 0;         ///< 0 for solvers without
};

/// That a job must keep to, or is fitted to, a part of what its forecast's is.
std::optional<double> asked_error(const Job& job);

/// Takes a fraction of a second. Throws what the job would throw in that time.
Forecast forecast(const Device& device, const Job& job);

/// What a picture takes, s, by the beginning of it. Throws as make_picture().
double picture_seconds(const Device& device, const PictureRequest& picture,
                       const std::vector<SceneMaterial>& materials);

/// Of a batch: nothing is computed of what an earlier run has finished or what equals another job.
std::vector<Forecast> forecasts(const Device& device, const std::vector<Job>& jobs);

}  // namespace gonio

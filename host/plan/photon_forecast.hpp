// SPDX-License-Identifier: Apache-2.0
// What a table by photons will cost, and how exact it will be.
#pragma once

#include "gonio/device.hpp"
#include "gonio/job.hpp"

namespace gonio {

struct PhotonForecast {
    double photons = 0, seconds = 0;
    double error = 0;  ///< the largest standard error, over the largest value
};

/// Of a job with layers that Monte Carlo solves, by some of its photons, which are followed now.
PhotonForecast forecast(const Device& device, const Job& job);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What is measured of a model on a device: accuracy, speed, and how much light it reflects at most.
#pragma once

#include "verify/gain.hpp"
#include "verify/verify.hpp"

namespace gonio {

struct Measured {
    Verdict verdict;
    double values_per_second = 0;  ///< of an isotropic table at default parameters
    double store_fraction = 0;     ///< of the rate at which the device writes such a table
    Gain gain;
};

Measured measure_model(const Device& device, const Model& model);

}  // namespace gonio

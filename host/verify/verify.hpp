// SPDX-License-Identifier: Apache-2.0
// Compares a model on a device with its reference over random and extreme directions and
// parameters.
#pragma once

#include <string>
#include <vector>

#include "gonio/device.hpp"
#include "verify/accuracy.hpp"

namespace gonio {

struct Verdict {
    std::string model;
    Accuracy accuracy;
    double bound = 0;
    double reciprocity_defect =
        0;  ///< largest |f(l, v) - f(v, l)| as a fraction of the maximum; 0 for one-way models
    std::size_t negative = 0;  ///< values below 0
    std::string worst;         ///< the parameters behind the largest error
    bool passed() const;
};

/// quick: a small part of the cases, for a first look at a device.
Verdict verify_model(const Device& device, const Model& model, bool quick);

}  // namespace gonio

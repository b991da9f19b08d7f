// SPDX-License-Identifier: Apache-2.0
// Quantities of layers by adding-doubling, without noise.
#pragma once

#include <vector>

#include "gonio/job.hpp"
#include "gonio/photons.hpp"
#include "reference/adding_doubling/refinement.hpp"

namespace gonio {

/// The largest error that a job's values have: its max_error, or where it has none what the
/// quantity is computed to; 0 where they are as exact as they can be, in a time or at all.
double tolerance_of(const LightJob& light);

/// What those errors are a part of: "the light".
const char* error_of(const LightJob& light);

struct ExactValues {
    std::vector<Fraction> values;  ///< in the order of the table; error: a bound
    int nodes = 0;                 ///< quadrature directions that it took
    double error = 0;              ///< that a max_error bounds, a part of what error_of() says
};

/// Of a job's layers, over the axes of its table: to its max_error, as exact as its time allows, or
/// whichever comes first. Throws RunError where the max_error is out of reach in any time.
/// `after_part` gets the part that is done; what it throws ends the work.
ExactValues exact_values(
    const LightJob& light, const std::vector<Axis>& axes,
    const reference::AfterPart& after_part = [](double) {});

/// A number for each part of a budget, in the order of the channels of light_budget.
template <class Budget>
auto parts_of(const Budget& budget)
{
    std::vector parts = {budget.specular, budget.diffuse_reflectance,
                         budget.unscattered_transmittance, budget.diffuse_transmittance,
                         budget.bottom_absorption};
    parts.insert(parts.end(), budget.absorption.begin(), budget.absorption.end());
    return parts;
}

}  // namespace gonio

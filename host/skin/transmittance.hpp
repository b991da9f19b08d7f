// SPDX-License-Identifier: Apache-2.0
// Light that goes through folds of skin.
#pragma once

#include <functional>
#include <vector>

#include "gonio/skin.hpp"

namespace gonio {

struct FoldSpectra {
    std::vector<std::vector<double>> transmittance;  ///< [set, then thickness][wavelength]
    double error = 0;                                ///< bound of all of these
};

/// Of each set of the task in folds of those thicknesses (cm). Throws and calls `after_each` as
/// solve_skin() does.
FoldSpectra solve_folds(const SkinTask& task, const std::vector<double>& thicknesses,
                        const std::function<void()>& after_each);

}  // namespace gonio

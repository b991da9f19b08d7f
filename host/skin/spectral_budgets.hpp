// SPDX-License-Identifier: Apache-2.0
// Where light ends in layers that change with the wavelength, without noise.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "gonio/layers.hpp"
#include "reference/adding_doubling.hpp"

namespace gonio {

/// Sets of layers, each at the same wavelengths.
struct SpectralMedia {
    std::size_t sets = 0, wavelengths = 0;
    /// Called by several threads.
    std::function<LayeredMedium(std::size_t set, std::size_t wavelength)> at;
};

struct SpectralBudgets {
    std::vector<std::vector<reference::LightBudget>> of;  ///< [set][wavelength]
    double error = 0;                                     ///< bound of all of these
};

/// By adding-doubling on all processors. `tolerance` is that of each number; the error is measured
/// at every sixteenth wavelength of every sixteenth set, and each wavelength has as many nodes as
/// the two around it need. Sets that follow each other and share layers share their solution.
/// Throws what `at` does, and RunError where the tolerance cannot be reached. `after_each` is
/// called after each medium, by several threads; what it throws ends the work.
SpectralBudgets solve_budgets(const SpectralMedia& media, const LightSource& light,
                              double tolerance, const std::function<void()>& after_each);

}  // namespace gonio

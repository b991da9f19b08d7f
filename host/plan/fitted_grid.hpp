// SPDX-License-Identifier: Apache-2.0
// Grids whose counts follow from an error.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gonio/job.hpp"

namespace gonio {

/// Directions up to here, in degrees, are what a fitted grid is right for.
inline constexpr double fitted_theta = 85;

inline constexpr double most_cells = 0x1p26;

/// Samples of each angle.
using Counts = std::vector<std::size_t>;

double cells_of(const Counts& counts);

Grid grid_of(const GridFit& fit, const Counts& counts);

/// The coarsest grid that is tried.
Grid coarsest_grid(const GridFit& fit);

/// In the same proportions about so many cells, at most `most_cells`.
Counts scaled(const Counts& counts, double cells);

struct FittedCounts {
    Counts counts;
    double error = 0;
};

/// Fits grids to all materials and channels of a job. Errors are those of interpolation, as a
/// fraction of the largest f: the largest over random pairs of directions and pairs near the mirror
/// direction.
class GridFitter {
public:
    /// Throws UsageError for sweeps of more than 64 materials.
    GridFitter(const Job& job, const GridFit& fit);
    ~GridFitter();
    GridFitter(const GridFitter&) = delete;
    GridFitter& operator=(const GridFitter&) = delete;

    /// The smallest grid found on which interpolation keeps to max_error. Where `most_cells` are
    /// not enough, the error stays above.
    FittedCounts fit(double max_error) const;

    double error(const Counts& counts) const;

private:
    class Trial;
    std::size_t angles_;
    std::unique_ptr<Trial> search_, check_;
};

/// Gives the job the grid that keeps to max_error, and the error that it has.
void fit_grid(Job& job, const GridFit& fit, double max_error);

}  // namespace gonio

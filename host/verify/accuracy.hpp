// SPDX-License-Identifier: Apache-2.0
// How far the device is from the reference: largest relative error where f is at least 1e-6 of the
// table's maximum, and largest absolute error as a fraction of that maximum below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/material.hpp"
#include "gonio/table.hpp"

namespace gonio {

struct Accuracy {
    double relative = 0;               ///< largest, where f >= 1e-6 of the maximum
    double absolute = 0;               ///< largest elsewhere, as a fraction of the maximum
    double maximum = 0;                ///< of the reference
    double device = 0, reference = 0;  ///< the two values behind `relative`
    std::size_t checked = 0;           ///< values compared
    std::size_t not_finite = 0;
    bool complete = true;  ///< every value was compared, not a sample

    /// Takes the worse of both.
    void merge(const Accuracy& other);
};

/// The bound that a material's traits set: 1e-5 for algebraic lobes, 5e-5 for exponential and power
/// lobes.
double accuracy_bound(const Material& material);

/// By how much of their size coordinates of directions may be wrong: what double leaves, and for
/// fits whose terms CANCEL what float32 leaves.
double direction_rounding(const Material& material);

/// What such an error in l or in v changes in the reference.
double sensitivity(const Reference& reference, glm::dvec3 l, glm::dvec3 v, std::size_t channel,
                   double rounding);

/// Pairs of values and how they compare beyond the reference's own sensitivity(k), which is asked
/// for where it may matter. reference[k] belongs to device[k].
Accuracy compare(const std::vector<float>& device, const std::vector<double>& reference,
                 const std::function<double(std::size_t)>& sensitivity);

/// Gathers cells of a table while its rows pass: all of up to 500 000, else 250 000 stratified
/// and the extremes. What was gathered is compared at the end, on all cores.
class AccuracyCheck {
public:
    AccuracyCheck(const Grid& grid, std::size_t channels);

    /// About how many of a table's values are compared.
    static std::size_t compared(std::size_t values);

    void see(const Rows<float>& rows);
    Accuracy finish(const Reference& reference, double rounding);

private:
    struct Sample {
        std::uint64_t cell;  ///< row * length + column
        float value;
        std::uint32_t channel;
    };

    Grid grid_;
    std::size_t channels_, length_ = 0, step_ = 1;
    std::vector<Sample> samples_;
    std::vector<Sample> extremes_;  ///< least and greatest of each channel
    std::size_t not_finite_ = 0;
};

}  // namespace gonio

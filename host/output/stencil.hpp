// SPDX-License-Identifier: Apache-2.0
// One axis of a lookup: which samples a coordinate is interpolated from, and with what weights.
#pragma once

#include <cstddef>
#include <vector>

#include "gonio/table.hpp"

namespace gonio {

/// cubic is Catmull and Rom's spline on uneven samples: a Hermite cubic whose slope at a sample is
/// that of the parabola through it and its neighbours. It reproduces parabolas; it may overshoot
/// beside a steep lobe, so take linear where no value may be negative.
enum class Interpolation { nearest, linear, cubic };

/// Beyond an axis' ends: an azimuth (its name holds "phi", its unit is "deg", three or more even
/// samples) over 360 degrees repeats; delta_phi over 180 degrees is mirrored, phi_d over 180
/// degrees repeats (reciprocity), phi_d over 90 degrees is mirrored. An angle from a pole that
/// starts there goes on behind it, on the other side of the circle. Every other end is held: beyond
/// it the last sample counts.
class Stencil {
public:
    enum class Start { end, pole };

    /// start: is 0 a pole, whose azimuth is another axis that goes all round?
    explicit Stencil(const Axis& axis, Start start = Start::end);

    /// A sample and its weight. Behind the pole it is the one half a turn of the azimuth away.
    struct Share {
        std::size_t sample;
        double weight;
        bool behind_pole;
    };

    /// The shares at `coordinate`, in the axis' unit. The weights sum to 1.
    std::vector<Share> at(double coordinate, Interpolation how) const;

    /// Does every coordinate lie between samples?
    bool goes_round() const { return beyond_ != Beyond::hold; }

private:
    enum class Beyond { hold, repeat, mirror };
    struct Point {
        std::size_t sample;
        double position;
        bool behind_pole;
    };

    bool exists(std::ptrdiff_t k) const;
    Point point(std::ptrdiff_t k) const;
    double into_range(double position) const;

    double sign_;                    // -1 where the axis falls, so that positions_ rises
    std::vector<double> positions_;  // the axis' values times sign_
    Beyond beyond_ = Beyond::hold;
    bool has_both_ends_;  // first and last sample are the ends: of a full circle they are the same
    bool has_pole_ = false;
    double low_ = 0;  // the ends of the range, where it repeats or is mirrored
    double high_ = 0;
};

}  // namespace gonio

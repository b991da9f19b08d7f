// SPDX-License-Identifier: Apache-2.0
// Weights of nearest, linear and cubic interpolation on one axis.
#include "output/stencil.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "output/conventions.hpp"

namespace gonio {
namespace {

bool is_near(double a, double b)
{
    return std::abs(a - b) < 1e-6;
}

/// Four neighbouring samples, the interval between the middle ones, and the weights so far.
struct Cubic {
    std::array<double, 4> x = {};
    std::array<bool, 4> exists = {};
    std::array<double, 4> weight = {};

    /// Adds scale times the slope between samples j and j + 1.
    void add_secant(std::size_t j, double scale)
    {
        const double slope = scale / (x[j + 1] - x[j]);
        weight[j + 1] += slope;
        weight[j] -= slope;
    }

    /// Adds scale times the slope at sample j of the parabola through j - 1, j and j + 1.
    void add_parabola(std::size_t j, double scale)
    {
        const double right = (x[j] - x[j - 1]) / (x[j + 1] - x[j - 1]);
        add_secant(j, scale * right);
        add_secant(j - 1, scale * (1 - right));
    }

    /// The slope at sample 1 or 2; at an end of the axis that of the last three samples' parabola.
    void add_slope(std::size_t j, double scale)
    {
        const std::size_t outer = j == 1 ? 0 : 3;
        const std::size_t other = 3 - j;
        if (exists[outer]) {
            add_parabola(j, scale);
        } else if (exists[3 - outer]) {
            add_secant(1, 2 * scale);
            add_parabola(other, -scale);
        } else {
            add_secant(1, scale);
        }
    }
};

}  // namespace

Stencil::Stencil(const Axis& axis, Start start)
    : sign_(axis.values.back() < axis.values.front() ? -1 : 1),
      has_both_ends_(axis.samples == Samples::node)
{
    for (const double value : axis.values) positions_.push_back(sign_ * value);
    has_pole_ = start == Start::pole && sign_ > 0 && positions_.size() > 1 && positions_[0] >= 0 &&
                positions_[0] <= positions_[1] - positions_[0];
    const auto count = static_cast<double>(positions_.size());
    const bool is_azimuth = axis.name.find("phi") != std::string::npos && axis.unit == "deg";
    if (!is_azimuth || count < 3 || !is_evenly_spaced(axis)) return;
    const double step = (positions_.back() - positions_.front()) / (count - 1);
    const double margin = has_both_ends_ ? 0 : step / 2;
    low_ = positions_.front() - margin;
    high_ = positions_.back() + margin;
    const bool is_half = is_near(high_ - low_, 180);
    if (is_near(high_ - low_, 360) || (is_half && axis.name == "phi_d")) {
        beyond_ = Beyond::repeat;
    } else if ((is_half && axis.name == "delta_phi") ||
               (is_near(high_ - low_, 90) && axis.name == "phi_d")) {
        beyond_ = Beyond::mirror;
    }
}

bool Stencil::exists(std::ptrdiff_t k) const
{
    return beyond_ != Beyond::hold || (k >= 0 && k < std::ssize(positions_)) ||
           (k < 0 && has_pole_);
}

/// Sample k, counted on beyond the ends; k is less than one range away from them.
Stencil::Point Stencil::point(std::ptrdiff_t k) const
{
    const auto count = std::ssize(positions_);
    const auto last = count - 1;
    const auto at = [&](std::ptrdiff_t j) { return positions_[static_cast<std::size_t>(j)]; };
    const auto index = [](std::ptrdiff_t j) { return static_cast<std::size_t>(j); };
    if (k >= 0 && k < count) return {index(k), at(k), false};
    if (has_pole_) {
        const auto j = positions_[0] == 0 ? -k : -k - 1;
        return {index(j), -at(j), true};
    }
    if (beyond_ == Beyond::repeat) {
        const auto period = has_both_ends_ ? last : count;
        const auto j = k < 0 ? k + period : k - period;
        return {index(j), at(j) + (k < 0 ? low_ - high_ : high_ - low_), false};
    }
    const auto skipped = has_both_ends_ ? 0 : 1;
    const auto j = k < 0 ? -k - skipped : 2 * last - k + skipped;
    return {index(j), 2 * (k < 0 ? low_ : high_) - at(j), false};
}

double Stencil::into_range(double position) const
{
    const double range = high_ - low_;
    if (beyond_ == Beyond::repeat) {
        return position - range * std::floor((position - low_) / range);
    }
    if (beyond_ == Beyond::mirror) {
        const double folded = position - 2 * range * std::floor((position - low_) / (2 * range));
        return folded > high_ ? 2 * high_ - folded : folded;
    }
    return std::clamp(position, has_pole_ ? 0 : positions_.front(), positions_.back());
}

std::vector<Stencil::Share> Stencil::at(double coordinate, Interpolation how) const
{
    if (positions_.size() == 1) return {{0, 1, false}};
    const double position = into_range(sign_ * coordinate);
    auto k =
        std::upper_bound(positions_.begin(), positions_.end(), position) - positions_.begin() - 1;
    if (!exists(k + 1)) --k;
    const double step = point(k + 1).position - point(k).position;
    const double t = (position - point(k).position) / step;
    const auto share = [this](std::ptrdiff_t j, double weight) {
        return Share{point(j).sample, weight, point(j).behind_pole};
    };
    if (how == Interpolation::nearest) return {share(t < 0.5 ? k : k + 1, 1)};
    if (how == Interpolation::linear) return {share(k, 1 - t), share(k + 1, t)};

    Cubic cubic;
    for (std::size_t j = 0; j < 4; ++j) {
        const auto neighbour = k - 1 + static_cast<std::ptrdiff_t>(j);
        cubic.exists[j] = exists(neighbour);
        if (cubic.exists[j]) cubic.x[j] = point(neighbour).position;
    }
    cubic.weight[1] = (1 + 2 * t) * (1 - t) * (1 - t);
    cubic.weight[2] = t * t * (3 - 2 * t);
    cubic.add_slope(1, step * t * (1 - t) * (1 - t));
    cubic.add_slope(2, -step * t * t * (1 - t));
    std::vector<Share> shares;
    for (std::size_t j = 0; j < 4; ++j) {
        if (!cubic.exists[j]) continue;
        shares.push_back(share(k - 1 + static_cast<std::ptrdiff_t>(j), cubic.weight[j]));
    }
    return shares;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// How far the device is from the reference.
#include "verify/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace gonio {
namespace {

constexpr double floor_of_relative = 1e-6;
constexpr std::size_t all_values = 500'000, sampled_values = 250'000;

}  // namespace

void Accuracy::merge(const Accuracy& other)
{
    if (other.relative > relative) {
        relative = other.relative;
        device = other.device;
        reference = other.reference;
    }
    absolute = std::max(absolute, other.absolute);
    maximum = std::max(maximum, other.maximum);
    checked += other.checked;
    not_finite += other.not_finite;
    complete = complete && other.complete;
}

double accuracy_bound(const Material& material)
{
    const bool exponential = std::ranges::any_of(
        material.lobes, [](const Lobe& lobe) { return (lobe.traits() & EXPONENTIAL) != 0; });
    return exponential ? 5e-5 : 1e-5;
}

double direction_rounding(const Material& material)
{
    const bool cancels = std::ranges::any_of(
        material.lobes, [](const Lobe& lobe) { return (lobe.traits() & CANCELS) != 0; });
    return cancels ? 0x1p-22 : 0x1p-52;
}

double sensitivity(const Reference& reference, glm::dvec3 l, glm::dvec3 v, std::size_t channel,
                   double rounding)
{
    const glm::dvec3 wrong(1 + rounding, 1 + rounding, 1 - rounding);
    const double f = reference(l, v, channel);
    return std::abs(reference(l * wrong, v, channel) - f) +
           std::abs(reference(l, v * wrong, channel) - f);
}

Accuracy compare(const std::vector<float>& device, const std::vector<double>& reference,
                 const std::function<double(std::size_t)>& sensitivity)
{
    Accuracy accuracy;
    accuracy.checked = device.size();
    for (const double f : reference)
        if (std::isfinite(f)) accuracy.maximum = std::max(accuracy.maximum, std::abs(f));
    // What float32 has no normal numbers for counts as 0.
    const double smallest = std::numeric_limits<float>::min();
    const double scale = std::max(accuracy.maximum, smallest);
    for (std::size_t k = 0; k < device.size(); ++k) {
        const double got = static_cast<double>(device[k]), expected = reference[k];
        if (!std::isfinite(got) || !std::isfinite(expected)) {
            ++accuracy.not_finite;
            continue;
        }
        const bool small = std::abs(expected) < std::max(floor_of_relative * scale, smallest);
        const double largest =
            small ? accuracy.absolute * scale : accuracy.relative * std::abs(expected);
        double error = std::abs(got - expected);
        if (error > largest) error -= sensitivity(k);
        if (error <= largest) continue;
        if (small) {
            accuracy.absolute = error / scale;
        } else {
            accuracy.relative = error / std::abs(expected);
            accuracy.device = got;
            accuracy.reference = expected;
        }
    }
    return accuracy;
}

AccuracyCheck::AccuracyCheck(const Grid& grid, std::size_t channels)
    : grid_(grid), channels_(channels)
{
    std::size_t cells = 1;
    for (const Axis& axis : grid.axes) cells *= axis.values.size();
    length_ = grid.axes.back().values.size();
    step_ = cells * channels / compared(cells * channels);
    samples_.reserve(cells * channels / step_ + channels);
    extremes_.resize(2 * channels);
}

std::size_t AccuracyCheck::compared(std::size_t values)
{
    return values <= all_values ? values : sampled_values;
}

void AccuracyCheck::see(const Rows<float>& rows)
{
    for (std::size_t c = 0; c < channels_; ++c) {
        const float* values = rows.planes[c];
        Sample& least = extremes_[2 * c];
        Sample& greatest = extremes_[2 * c + 1];
        for (std::size_t k = 0; k < rows.count * length_; ++k) {
            const std::uint64_t cell = rows.first * length_ + k;
            const auto channel = static_cast<std::uint32_t>(c);
            if (!std::isfinite(values[k])) ++not_finite_;
            if (cell == 0 || values[k] < least.value) least = {cell, values[k], channel};
            if (cell == 0 || values[k] > greatest.value) greatest = {cell, values[k], channel};
            // One cell of every stratum of step_ cells, at a place that a multiplicative hash of
            // the stratum chooses.
            const std::uint64_t place = cell / step_ * 0x9e3779b97f4a7c15ULL >> 32;
            if (cell % step_ == place % step_) samples_.push_back({cell, values[k], channel});
        }
    }
}

Accuracy AccuracyCheck::finish(const Reference& reference, double rounding)
{
    if (step_ > 1) samples_.insert(samples_.end(), extremes_.begin(), extremes_.end());
    std::vector<float> device(samples_.size());
    std::vector<double> expected(samples_.size());
    const GridVectors vectors(grid_);
    const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
    {
        std::vector<std::jthread> threads;
        for (std::size_t w = 0; w < workers; ++w)
            threads.emplace_back([&, w] {
                const std::size_t begin = samples_.size() * w / workers,
                                  end = samples_.size() * (w + 1) / workers;
                for (std::size_t k = begin; k < end; ++k) {
                    const Sample& sample = samples_[k];
                    const auto [l, v] = vectors.at(sample.cell / length_, sample.cell % length_);
                    device[k] = sample.value;
                    expected[k] = l.z > 0 && v.z > 0 ? reference(l, v, sample.channel) : 0;
                    // On the horizon the table holds 0 for a pole; the limit itself is compared.
                    const bool horizon = std::min(l.z, v.z) < 2e-11;
                    if (horizon && sample.value == 0) expected[k] = 0;
                }
            });
    }
    Accuracy accuracy = compare(device, expected, [&](std::size_t k) {
        const auto [l, v] = vectors.at(samples_[k].cell / length_, samples_[k].cell % length_);
        return sensitivity(reference, l, v, samples_[k].channel, rounding);
    });
    accuracy.not_finite = std::max(accuracy.not_finite, not_finite_);
    accuracy.complete = step_ == 1;
    return accuracy;
}

}  // namespace gonio

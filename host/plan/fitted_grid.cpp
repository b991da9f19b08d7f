// SPDX-License-Identifier: Apache-2.0
// Every axis as coarse as its share of the error allows.
#include "plan/fitted_grid.hpp"

#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "compute/horizon.hpp"
#include "gonio/errors.hpp"
#include "output/grid_coordinates.hpp"
#include "output/lookup.hpp"
#include "parallel.hpp"

namespace gonio {
namespace {

constexpr std::size_t coarsest = 6;   // samples of an angle
constexpr std::size_t finest = 4096;  // of the other angles, while one is chosen
constexpr double finer = 1.25, coarser = 0.92;
constexpr double aim = 0.8;  // of the error asked for: the pairs tried are not all there are
constexpr std::size_t most_materials = 64;
constexpr std::size_t searched_pairs = 2048, checked_pairs = 16384, portion = 128;

/// Even in cosines and azimuths, and as many around the mirror direction.
std::vector<DirectionPair> some_pairs(std::size_t count, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(0, 1);
    const double least = std::cos(fitted_theta * std::numbers::pi / 180);
    const auto theta = [&] {
        return std::acos(least + (1 - least) * even(random)) * 180 / std::numbers::pi;
    };
    // From 0.01 to 30 degrees, to either side.
    const auto offset = [&] {
        const double size = std::pow(10, -2 + 3.5 * even(random));
        return even(random) < 0.5 ? -size : size;
    };
    std::vector<DirectionPair> pairs(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double theta_i = theta(), phi_i = 360 * even(random);
        pairs[k] = {theta_i, phi_i, theta(), 360 * even(random)};
        if (k % 2 == 0) continue;
        pairs[k].theta_o = std::clamp(theta_i + offset(), 0.0, fitted_theta);
        pairs[k].phi_o = std::fmod(phi_i + 540 + offset(), 360);
    }
    return pairs;
}

std::size_t angles(GridKind kind)
{
    return kind == GridKind::anisotropic ? 4 : 3;
}

}  // namespace

/// What a job's materials are at some pairs, and how far interpolation is off there.
class GridFitter::Trial {
public:
    Trial(const Job& job, const GridFit& fit, std::size_t pairs, unsigned seed)
        : fit_(fit), half_(stores_half(job)), pairs_(some_pairs(pairs, seed))
    {
        for (const Material& material : job.materials) {
            const Reference f = make_reference(material, job.measure);
            for (std::size_t c = 0; c < material.channels(); ++c) values_.push_back({f, c});
        }
        for (const Value& value : values_) {
            std::vector<double> right(pairs_.size());
            in_parallel((pairs_.size() + portion - 1) / portion, [&](std::size_t part) {
                for_portion(part, [&](std::size_t k) {
                    const auto [l, v] = unit_vectors(pairs_[k]);
                    right[k] = value.f(l, v, value.channel);
                });
            });
            peaks_.push_back(*std::ranges::max_element(right));
            right_.push_back(std::move(right));
        }
    }

    double error(const Counts& counts) const
    {
        const Grid grid = grid_of(fit_, counts);
        Table empty;
        empty.header.axes = grid.axes;
        const Lookup lookup(empty, fit_.cubic ? Interpolation::cubic : Interpolation::linear);
        const GridVectors vectors(grid);
        std::vector<double> worst((pairs_.size() + portion - 1) / portion);
        in_parallel(worst.size(), [&](std::size_t part) {
            for_portion(part, [&](std::size_t k) {
                const auto cells = lookup.cells_at(grid_coordinates(fit_.kind, pairs_[k]));
                for (std::size_t m = 0; m < values_.size(); ++m) {
                    double sum = 0;
                    for (const auto& [cell, weight] : cells)
                        sum += weight * stored(vectors, cell, grid.axes.back().values.size(), m);
                    worst[part] = std::max(worst[part], std::abs(sum - right_[m][k]) / peaks_[m]);
                }
            });
        });
        return *std::ranges::max_element(worst);
    }

private:
    /// A channel of a material.
    struct Value {
        Reference f;
        std::size_t channel;
    };

    template <class Work>
    void for_portion(std::size_t part, const Work& work) const
    {
        const std::size_t end = std::min((part + 1) * portion, pairs_.size());
        for (std::size_t k = part * portion; k < end; ++k) work(k);
    }

    /// What the table holds.
    double stored(const GridVectors& vectors, std::size_t cell, std::size_t length,
                  std::size_t which) const
    {
        const auto [l, v] = vectors.at(cell / length, cell % length);
        const auto& [f, channel] = values_[which];
        if (fit_.kind == GridKind::rusinkiewicz && std::min(l.z, v.z) <= rusinkiewicz_horizon)
            return 0;
        if (!has_limit_on_horizon(f, l, v, channel)) return 0;
        const double value = f(l, v, channel);
        return half_ ? double(float(half(float(value)))) : value;
    }

    GridFit fit_;
    bool half_;
    std::vector<DirectionPair> pairs_;
    std::vector<Value> values_;
    std::vector<std::vector<double>> right_;
    std::vector<double> peaks_;
};

double cells_of(const Counts& counts)
{
    double cells = 1;
    for (const std::size_t count : counts) cells *= double(count);
    return cells;
}

Grid grid_of(const GridFit& fit, const Counts& n)
{
    switch (fit.kind) {
        case GridKind::isotropic:
            return isotropic_grid(n[0], n[1], n[2], fit.samples, fit.delta_phi_to);
        case GridKind::anisotropic:
            return anisotropic_grid(n[0], n[1], n[2], n[3], fit.samples);
        case GridKind::rusinkiewicz:
            break;
    }
    return rusinkiewicz_grid(n[0], n[1], n[2], fit.samples, fit.spacing);
}

Grid coarsest_grid(const GridFit& fit)
{
    return grid_of(fit, Counts(angles(fit.kind), coarsest));
}

Counts scaled(const Counts& counts, double cells)
{
    Counts result = counts;
    const double wanted = std::min(cells, most_cells);
    const double factor = std::pow(wanted / cells_of(counts), 1 / double(counts.size()));
    for (std::size_t& count : result)
        count = std::max(coarsest, static_cast<std::size_t>(double(count) * factor));
    return result;
}

namespace {

/// The fewest samples of one angle with which interpolation keeps to an error, where the others
/// have so many that they add nothing; `finest` where none do.
template <class Error>
std::size_t samples_of(const Error& error_of, std::size_t angles, std::size_t axis, double error)
{
    Counts counts(angles, finest);
    counts[axis] = coarsest;
    while (counts[axis] < finest && error_of(counts) > error)
        counts[axis] = std::min(finest, static_cast<std::size_t>(double(counts[axis]) * finer) + 1);
    return counts[axis];
}

Counts made_coarser(Counts counts)
{
    for (std::size_t& count : counts)
        count = std::max(coarsest, static_cast<std::size_t>(double(count) * coarser));
    return counts;
}

/// Each angle by its own share of the error; then all of them as coarse as the whole allows.
template <class Error>
Counts counts_for(const Error& error_of, std::size_t angles, double error)
{
    Counts counts;
    for (std::size_t axis = 0; axis < angles; ++axis)
        counts.push_back(samples_of(error_of, angles, axis, error / double(angles)));
    for (;;) {
        const Counts fewer = made_coarser(counts);
        if (fewer == counts || error_of(fewer) > error) return counts;
        counts = fewer;
    }
}

}  // namespace

GridFitter::GridFitter(const Job& job, const GridFit& fit) : angles_(angles(fit.kind))
{
    if (job.materials.size() > most_materials)
        throw UsageError(fmt::format(
            "{}a sweep of {} materials on a grid that is fitted to all of them; allowed are {}",
            job.where, job.materials.size(), most_materials));
    search_ = std::make_unique<Trial>(job, fit, searched_pairs, 1);
    check_ = std::make_unique<Trial>(job, fit, checked_pairs, 2);
}

GridFitter::~GridFitter() = default;

double GridFitter::error(const Counts& counts) const
{
    return std::max(search_->error(counts), check_->error(counts));
}

FittedCounts GridFitter::fit(double max_error) const
{
    FittedCounts fitted;
    const auto error_of = [&](const Counts& counts) { return search_->error(counts); };
    for (double target = aim * max_error;; target *= aim) {
        const Counts wanted = counts_for(error_of, angles_, target);
        const bool fits = cells_of(wanted) <= most_cells;
        if (!fits && !fitted.counts.empty()) break;
        fitted.counts = wanted;
        while (cells_of(fitted.counts) > most_cells) fitted.counts = made_coarser(fitted.counts);
        fitted.error = error(fitted.counts);
        if (fitted.error <= max_error || !fits) break;
    }
    return fitted;
}

void fit_grid(Job& job, const GridFit& fit, double max_error)
{
    const FittedCounts fitted = GridFitter(job, fit).fit(max_error);
    job.grid = grid_of(fit, fitted.counts);
    job.interpolation_error = fitted.error;
    job.max_error = max_error;
    job.must_reach = true;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Sums of integer weights over batches of photons, exact, with errors from the batches' spread.
#include "photon/weight_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/errors.hpp"
#include "photon/program.hpp"

namespace gonio {

void WeightSums::add_batch(const std::vector<std::uint64_t>& weights, std::uint64_t photons)
{
    for (std::size_t k = 0; k < sums_.size(); ++k) {
        const double whole = static_cast<double>(weights[k]) / whole_photon;
        sums_[k] += weights[k];
        squares_[k] += whole * whole / static_cast<double>(photons);
    }
    photons_ += photons;
    ++batches_;
}

nlohmann::json WeightSums::state() const
{
    std::vector<std::uint64_t> low, high;
    for (const Sum sum : sums_) {
        low.push_back(static_cast<std::uint64_t>(sum));
        high.push_back(static_cast<std::uint64_t>(sum >> 64));
    }
    return {{"low", low},
            {"high", high},
            {"squares", squares_},
            {"photons", photons_},
            {"batches", batches_}};
}

void WeightSums::restore(const nlohmann::json& state)
{
    const auto low = state.at("low").get<std::vector<std::uint64_t>>();
    const auto high = state.at("high").get<std::vector<std::uint64_t>>();
    const auto squares = state.at("squares").get<std::vector<double>>();
    if (low.size() != sums_.size() || high.size() != sums_.size() || squares.size() != sums_.size())
        throw UsageError("a state of other sums");
    for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] = Sum{high[k]} << 64 | low[k];
    squares_ = squares;
    photons_ = state.at("photons");
    batches_ = state.at("batches");
}

/// The variance of a photon's score, from the spread of the means of batches of m photons, each
/// weighted with m.
Fraction WeightSums::fraction(std::size_t place) const
{
    if (batches_ == 0) return {0, std::numeric_limits<double>::infinity()};
    const double n = static_cast<double>(photons_);
    const double sum = static_cast<double>(sums_[place]) / whole_photon;
    if (batches_ == 1) return {sum / n, std::numeric_limits<double>::infinity()};
    const double spread = std::max(squares_[place] - sum * sum / n, 0.0);
    return {sum / n, std::sqrt(spread / static_cast<double>(batches_ - 1) / n)};
}

std::vector<Fraction> WeightSums::fractions(std::size_t first, std::size_t count) const
{
    std::vector<Fraction> all;
    for (std::size_t k = 0; k < count; ++k) all.push_back(fraction(first + k));
    return all;
}

}  // namespace gonio

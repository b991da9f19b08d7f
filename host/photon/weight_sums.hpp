// SPDX-License-Identifier: Apache-2.0
// Sums of integer weights over batches of photons, exact, with errors from the batches' spread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "gonio/photons.hpp"

namespace gonio {

class WeightSums {
public:
    explicit WeightSums(std::size_t count) : sums_(count), squares_(count) {}

    /// What a batch of photons left in each sum, in units of 2^-30 photons. Batches are independent
    /// and may differ in size.
    void add_batch(const std::vector<std::uint64_t>& weights, std::uint64_t photons);

    nlohmann::json state() const;
    /// Throws UsageError for a state of other sums, nlohmann::json::exception for none.
    void restore(const nlohmann::json& state);

    std::uint64_t photons() const { return photons_; }

    /// Per photon; means are exact to double's rounding up to 2^64 photons.
    Fraction fraction(std::size_t place) const;
    std::vector<Fraction> fractions(std::size_t first, std::size_t count) const;

private:
    __extension__ using Sum = unsigned __int128;

    std::vector<Sum> sums_;
    std::vector<double> squares_;  ///< of a batch's photons, over their number
    std::uint64_t photons_ = 0, batches_ = 0;
};

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Sums of scores whose standard errors come from the spread of equal batches.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace gonio::reference {

struct Estimate {
    double mean = 0;
    double error = 0;  ///< standard error of the mean
};

/// Any number of tallies, one behind the other.
class BatchScores {
public:
    /// Makes room for a tally of `count` bins; returns the place of its first. Before the first
    /// score.
    std::size_t append(std::size_t count)
    {
        batch_.resize(batch_.size() + count);
        sum_.resize(batch_.size());
        squares_.resize(batch_.size());
        return batch_.size() - count;
    }

    void add(std::size_t place, double score) { batch_[place] += score; }

    void end_batch()
    {
        for (std::size_t i = 0; i < batch_.size(); ++i) {
            sum_[i] += batch_[i];
            squares_[i] += batch_[i] * batch_[i];
            batch_[i] = 0;
        }
        ++batches_;
    }

    /// Of the score per trial, `trials` of which were in each batch.
    Estimate estimate(std::size_t place, std::size_t trials) const
    {
        const auto n = double(batches_);
        const double mean = sum_[place] / n;
        const double variance = std::max(squares_[place] / n - mean * mean, 0.0) / (n - 1);
        return {mean / double(trials), std::sqrt(variance) / double(trials)};
    }

    std::vector<Estimate> estimates(std::size_t first, std::size_t count, std::size_t trials) const
    {
        std::vector<Estimate> all;
        for (std::size_t i = 0; i < count; ++i) all.push_back(estimate(first + i, trials));
        return all;
    }

private:
    std::vector<double> batch_, sum_, squares_;
    std::size_t batches_ = 0;
};

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Many noisy numbers against exact ones, at one significance for all of them together.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "reference/batch_scores.hpp"

namespace gonio::test {

/// Where all is right, one such test in a hundred would fail. Seeds are fixed, so that it does
/// always or never.
class ZTest {
public:
    /// The mean of `trials` scores in [0, 1], or of scores that never vary.
    void add(std::string name, reference::Estimate measured, double expected, std::size_t trials)
    {
        comparisons_.push_back({std::move(name), measured, expected, double(trials)});
    }

    /// The significance of one comparison is Sidak's (J. Am. Stat. Assoc. 62, 1967) for their
    /// number.
    void expect_only_noise() const
    {
        constexpr double significance = 0.01;
        const double level = -std::expm1(std::log1p(-significance) / double(comparisons_.size()));
        for (const auto& [name, measured, expected, trials] : comparisons_) {
            const double deviation = std::abs(measured.mean - expected);
            if (measured.error > 0) {
                const double z = deviation / measured.error;
                EXPECT_GT(std::erfc(z / std::numbers::sqrt2), level)
                    << name << ": " << measured.mean << " +- " << measured.error << " and not "
                    << expected << ", " << z << " standard errors";
            } else if (measured.mean == 0 && expected > 0) {
                EXPECT_GT(std::exp(trials * std::log1p(-expected)), level)
                    << name << " never happened in " << trials << " trials, and should in "
                    << expected << " of them";
            } else {
                EXPECT_LT(deviation, 1e-12)
                    << name << ": " << measured.mean << " and not " << expected;
            }
        }
    }

private:
    struct Comparison {
        std::string name;
        reference::Estimate measured;
        double expected;
        double trials;
    };
    std::vector<Comparison> comparisons_;
};

}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// Solutions with more and more nodes until two of them agree, and how far that is.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "reference/adding_doubling/directions.hpp"

namespace gonio::reference {

/// Gets the part of the work that is done, as far as it can be told. What it throws ends the work.
using AfterPart = std::function<void(double part)>;

/// Asked before each further solution, with its work over that of the last one, which stays where
/// it says no.
using GoesOn = std::function<bool(double growth)>;

inline bool goes_on_always(double)
{
    return true;
}

struct Refinement {
    double tolerance;  ///< 0: as close as the nodes come
    double most_nodes;
    std::size_t exact;  ///< directions besides the nodes
};

template <class Solution>
struct Refined {
    Solution solution;
    double error;
    bool enough;  ///< to the tolerance, or as asked
};

/// solve(nodes, after_part) solves once; compare(solution, coarser one) returns the error.
template <class Solve, class Compare>
auto refine(const Refinement& wanted, const AfterPart& after_part, const GoesOn& goes_on,
            const Solve& solve, const Compare& compare)
{
    constexpr double first = 24, step = std::numbers::sqrt2;
    const auto exact = static_cast<double>(wanted.exact);
    const auto cost = [&](double nodes) { return nodes * (nodes + exact) * (nodes + exact); };
    // Where the error falls about exponentially, from 1 at 0 nodes on; at first as it does in
    // tissue.
    const auto enough = [&](double nodes, double error) {
        const double fallen = nodes * std::log(wanted.tolerance) / std::log(error);
        return step * std::clamp(fallen, nodes, wanted.most_nodes / step);
    };
    double done = 0, last = enough(first, 0.03);
    const auto solve_with = [&](double nodes) {
        double all = done + cost(nodes);
        for (double later = nodes * step; later <= last; later *= step) all += cost(later);
        auto solution = solve(static_cast<int>(std::lround(nodes)),
                              [&](double part) { after_part((done + part * cost(nodes)) / all); });
        done += cost(nodes);
        return solution;
    };
    auto coarse = solve_with(coarser(int(first)));
    for (double nodes = first;; nodes *= step) {
        auto solution = solve_with(nodes);
        const double error = compare(solution, coarse);
        const bool reached = error <= wanted.tolerance, last_one = nodes * step > wanted.most_nodes;
        if (reached || last_one || !goes_on(cost(nodes * step) / cost(nodes)))
            return Refined<decltype(coarse)>{std::move(solution), error,
                                             reached || !last_one || wanted.tolerance == 0};
        last = enough(nodes, error);
        coarse = std::move(solution);
    }
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Sobol's points: those that are printed, and that they are nets, scrambled or not.
#include "timings/sobol.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace gonio {
namespace {

/// Joe and Kuo print the first points of three dimensions with their direction numbers, in another
/// order: https://web.maths.unsw.edu.au/~fkuo/sobol/
TEST(Sobol, HasThePrintedPoints)
{
    using Point = std::array<double, 3>;
    const std::set<Point> printed = {{0, 0, 0},
                                     {0.5, 0.5, 0.5},
                                     {0.75, 0.25, 0.25},
                                     {0.25, 0.75, 0.75},
                                     {0.375, 0.375, 0.625},
                                     {0.875, 0.875, 0.125},
                                     {0.625, 0.125, 0.875},
                                     {0.125, 0.625, 0.375}};
    std::set<Point> found;
    for (std::uint32_t point = 0; point < 8; ++point)
        found.insert(
            {sobol(point, 0) * 0x1p-32, sobol(point, 1) * 0x1p-32, sobol(point, 2) * 0x1p-32});
    EXPECT_EQ(found, printed);
}

/// Of 2^bits points each interval of that length has one, in every dimension; and of the first two
/// dimensions, which are a (0, 2)-sequence, so has each rectangle of that area.
TEST(Sobol, PutsOnePointIntoEachInterval)
{
    constexpr unsigned bits = 10;
    for (const std::uint32_t key : {0U, 12345U, 0xdeadbeefU}) {
        const auto coordinate = [&](std::uint32_t point, std::size_t dimension) {
            const std::uint32_t plain = sobol(point, dimension);
            return key == 0 ? plain
                            : owen_scrambled(plain, key + static_cast<std::uint32_t>(dimension));
        };
        for (std::size_t dimension = 0; dimension < sobol_dimensions; ++dimension) {
            std::set<std::uint32_t> intervals;
            for (std::uint32_t point = 0; point < 1U << bits; ++point)
                intervals.insert(coordinate(point, dimension) >> (32 - bits));
            EXPECT_EQ(intervals.size(), 1U << bits) << dimension;
        }
        for (unsigned x_bits = 1; x_bits < bits; ++x_bits) {
            std::set<std::uint32_t> rectangles;
            for (std::uint32_t point = 0; point < 1U << bits; ++point)
                rectangles.insert(coordinate(point, 0) >> (32 - x_bits) << (bits - x_bits) |
                                  coordinate(point, 1) >> (32 - bits + x_bits));
            EXPECT_EQ(rectangles.size(), 1U << bits) << x_bits;
        }
    }
}

TEST(Sobol, IsScrambledByTheKey)
{
    std::set<std::uint32_t> firsts;
    for (std::uint32_t key = 1; key <= 64; ++key) firsts.insert(owen_scrambled(0, key) >> 26);
    EXPECT_GT(firsts.size(), 30U);  // of 64 intervals; by chance 41
}

}  // namespace
}  // namespace gonio

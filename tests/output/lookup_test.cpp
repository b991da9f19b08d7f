// SPDX-License-Identifier: Apache-2.0
// Interpolation reproduces what it must: samples, lines, parabolas, circles, symmetry.
#include "output/lookup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

constexpr auto nearest = Interpolation::nearest;
constexpr auto linear = Interpolation::linear;
constexpr auto cubic = Interpolation::cubic;

Axis axis_from(const std::string& name, std::size_t count, double from, double to, Samples samples)
{
    Axis axis{name, "deg", {}, samples};
    const double shift = samples == Samples::centre ? 0.5 : 0;
    const double cells = static_cast<double>(count) - (samples == Samples::node ? 1 : 0);
    for (std::size_t k = 0; k < count; ++k) {
        axis.values.push_back(from + (to - from) * (static_cast<double>(k) + shift) / cells);
    }
    return axis;
}

Table sampled(const Axis& axis, const std::function<double(double)>& f)
{
    Table table;
    table.header.axes = {axis};
    table.header.channels = {"Y"};
    auto& plane = table.values.emplace_back();
    for (const double x : axis.values) plane.push_back(f(x));
    return table;
}

double at(const Table& table, double x, Interpolation how)
{
    return Lookup(table, how).at(std::vector{x}).front();
}

double cosine(double degrees)
{
    return std::cos(degrees * std::numbers::pi / 180);
}
double sine(double degrees)
{
    return std::sin(degrees * std::numbers::pi / 180);
}

const Axis uneven = {"theta_i", "deg", {0, 1, 3, 7, 12, 20}, Samples::node};

TEST(Lookup, GivesTheSamplesThemselves)
{
    const auto table = sampled(uneven, sine);
    for (const auto how : {nearest, linear, cubic}) {
        for (std::size_t k = 0; k < uneven.values.size(); ++k) {
            EXPECT_DOUBLE_EQ(at(table, uneven.values[k], how), table.values[0][k]);
        }
    }
}

TEST(Lookup, NearestTakesTheNearest)
{
    const auto table = sampled(uneven, [](double x) { return x; });
    EXPECT_EQ(at(table, 4.9, nearest), 3);
    EXPECT_EQ(at(table, 5.1, nearest), 7);
}

TEST(Lookup, LinearReproducesLinesAndCubicParabolas)
{
    const auto line = [](double x) { return 3 - 2 * x; };
    const auto parabola = [](double x) { return 1 + x - 0.25 * x * x; };
    for (auto axis : {uneven, uneven}) {
        for (double x = 0; x <= 20; x += 0.37) {
            EXPECT_NEAR(at(sampled(axis, line), x, linear), line(x), 1e-12);
            EXPECT_NEAR(at(sampled(axis, parabola), x, cubic), parabola(x), 1e-12);
        }
        std::reverse(axis.values.begin(), axis.values.end());
    }
}

TEST(Lookup, FallingAxesAreLikeRisingOnes)
{
    auto falling = uneven;
    std::reverse(falling.values.begin(), falling.values.end());
    for (const auto how : {nearest, linear, cubic}) {
        for (double x = -1; x <= 21; x += 0.37) {
            EXPECT_NEAR(at(sampled(falling, sine), x, how), at(sampled(uneven, sine), x, how),
                        1e-14);
        }
    }
}

TEST(Lookup, HoldsTheEndsOfOtherAxes)
{
    const auto table = sampled(uneven, [](double x) { return x * x; });
    for (const auto how : {nearest, linear, cubic}) {
        EXPECT_DOUBLE_EQ(at(table, -5, how), 0);
        EXPECT_DOUBLE_EQ(at(table, 95, how), 400);
    }
}

TEST(Lookup, AxesOfOneOrTwoSamplesWork)
{
    const Axis one = {"theta_i", "deg", {30}, Samples::centre};
    const Axis two = {"phi_i", "deg", {0, 10}, Samples::node};
    for (const auto how : {nearest, linear, cubic})
        EXPECT_EQ(at(sampled(one, sine), 80, how), sine(30));
    EXPECT_DOUBLE_EQ(at(sampled(two, [](double x) { return x; }), 2.5, cubic), 2.5);
}

TEST(Lookup, FullCirclesRepeat)
{
    for (const auto samples : {Samples::centre, Samples::node}) {
        const auto table = sampled(axis_from("phi_o", 73, 0, 360, samples), sine);
        for (double phi = -720; phi < 1080; phi += 7.3) {
            EXPECT_NEAR(at(table, phi, linear), sine(phi), 1e-3) << phi;
            EXPECT_NEAR(at(table, phi, cubic), sine(phi), 2e-5) << phi;
        }
    }
    const auto shifted = sampled(axis_from("delta_phi", 72, -180, 180, Samples::centre), sine);
    EXPECT_NEAR(at(shifted, 181, cubic), sine(181), 1e-5);
}

TEST(Lookup, HalfAndQuarterCirclesAreMirroredOrReciprocal)
{
    for (const auto samples : {Samples::centre, Samples::node}) {
        const auto mirrored = sampled(axis_from("delta_phi", 37, 0, 180, samples), cosine);
        const auto reciprocal = sampled(axis_from("phi_d", 37, 0, 180, samples),
                                        [](double phi) { return sine(2 * phi); });
        const auto quarter = sampled(axis_from("phi_d", 37, 0, 90, samples),
                                     [](double phi) { return cosine(2 * phi); });
        for (double phi = -400; phi < 800; phi += 7.3) {
            EXPECT_NEAR(at(mirrored, phi, cubic), cosine(phi), 2e-5) << phi;
            EXPECT_NEAR(at(reciprocal, phi, cubic), sine(2 * phi), 3e-4) << phi;
            EXPECT_NEAR(at(quarter, phi, cubic), cosine(2 * phi), 2e-5) << phi;
        }
    }
}

TEST(Lookup, MultipliesAxesAndKeepsChannelsApart)
{
    Table table;
    table.header.axes = {{"alpha", "1", {0.1, 0.4}, Samples::node},
                         uneven,
                         {"theta_o", "deg", {0, 2, 3, 10}, Samples::node}};
    table.header.sweep_axes = 1;
    table.header.channels = {"R", "G"};
    table.values.resize(2);
    const auto f = [](double a, double x, double y) { return a * (2 + x) * (y - 1); };
    for (const double a : table.header.axes[0].values) {
        for (const double x : table.header.axes[1].values) {
            for (const double y : table.header.axes[2].values) {
                table.values[0].push_back(f(a, x, y));
                table.values[1].push_back(-f(a, x, y));
            }
        }
    }
    for (const auto how : {linear, cubic}) {
        const auto got = Lookup(table, how).at(std::vector{0.4, 5.5, 7.25});
        EXPECT_NEAR(got[0], f(0.4, 5.5, 7.25), 1e-12);
        EXPECT_NEAR(got[1], -f(0.4, 5.5, 7.25), 1e-12);
    }
    const Lookup lookup(table, linear);
    EXPECT_THROW(lookup.at(std::vector{0.2, 5.5, 7.25}), UsageError);
    EXPECT_THROW(lookup.at(std::vector{0.4, 5.5}), UsageError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(lookup.at(std::vector{0.4, nan, 1.0}), UsageError);
}

TEST(Lookup, IgnoresMissingValuesWithoutWeight)
{
    auto table = sampled(uneven, [](double x) { return x; });
    table.values[0][4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(at(table, 7, linear), 7);
    EXPECT_TRUE(std::isnan(at(table, 7.1, linear)));
}

}  // namespace
}  // namespace gonio

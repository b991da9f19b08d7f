// SPDX-License-Identifier: Apache-2.0
// The lobe of model lebedev is that of GGX, and its residual is interpolated as it should be.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gonio/grid.hpp"
#include "gonio/material.hpp"

namespace gonio {
namespace {

double value_of(const Lobe& lobe, const DirectionPair& pair)
{
    const auto [l, v] = unit_vectors(pair);
    return make_reference({"", {lobe}}, Measure::brdf)(l, v, 0);
}

/// theta_h, theta_d and phi_d (degrees) to numbers, over a grid.
Table table_of(const Grid& grid, double (*f)(double, double, double))
{
    Table table;
    table.header.quantity = residual_quantity;
    table.header.axes = grid.axes;
    table.header.channels = {"Y"};
    auto& plane = table.values.emplace_back();
    for (const double h : grid.axes[0].values)
        for (const double d : grid.axes[1].values)
            for (const double phi : grid.axes[2].values) plane.push_back(f(h, d, phi));
    return table;
}

/// Of the lobe 1/pi.
Lobe with_residual(const Table& table)
{
    Lobe lobe = default_lobe("lebedev");
    lobe.set("k_d", std::vector{1.0});
    lobe.set("k_s", std::vector{0.0});
    lobe.tables.resize(lobe.values.size());
    lobe.tables.back() = std::make_shared<const ResidualGrid>(residual_of(table, "test"));
    return lobe;
}

TEST(LebedevReference, WithoutAResidualItIsLambertAndFacets)
{
    Lobe lebedev = default_lobe("lebedev"), facets = default_lobe("ggx"),
         base = default_lobe("lambert");
    base.set("rho", std::vector{0.2});
    facets.set("alpha", std::vector{0.2});
    for (const DirectionPair& pair :
         {DirectionPair{30, 0, 30, 180}, {45, 0, 20, 150}, {80, 10, 85, 200}, {60, 40, 50, 45}}) {
        const double expected = value_of(base, pair) + 0.5 * value_of(facets, pair);
        EXPECT_NEAR(value_of(lebedev, pair), expected, 1e-12 * expected);
    }
}

TEST(LebedevReference, ALinearResidualIsExact)
{
    for (const auto samples : {Samples::centre, Samples::node}) {
        const auto grid = rusinkiewicz_grid(30, 30, 30, samples);
        const Lobe lobe = with_residual(
            table_of(grid, [](double h, double d, double) { return 0.05 * h - 0.2 * d; }));
        // In the plane of incidence theta_h is half the difference of the angles, theta_d half
        // their sum. Nearer to the pole than a cell the mean over phi_d takes part.
        for (const double i : {10.0, 40.0})
            for (const double o : {2.0, 25.0, 48.0}) {
                const double h = std::abs(i - o) / 2, d = (i + o) / 2;
                const double logarithm =
                    std::log(std::numbers::pi * value_of(lobe, {i, 0, o, 180}));
                EXPECT_NEAR(logarithm, 0.05 * h - 0.2 * d, 2e-6);
            }
    }
}

TEST(LebedevReference, IsReciprocalAndItsOwnMirrorImage)
{
    const auto grid = rusinkiewicz_grid(20, 20, 24, Samples::centre, Spacing::merl);
    const Lobe lobe = with_residual(table_of(
        grid, [](double h, double d, double phi) { return 9 * std::sin(h + 3 * d + 5 * phi); }));
    for (double i = 1; i < 90; i += 11)
        for (double o = 2; o < 90; o += 13)
            for (double phi = 3; phi < 180; phi += 17) {
                const double f = value_of(lobe, {i, 0, o, phi});
                EXPECT_NEAR(f, value_of(lobe, {o, 0, i, phi}), 1e-9 * f);
                EXPECT_NEAR(f, value_of(lobe, {i, 0, o, -phi}), 1e-9 * f);
            }
}

}  // namespace
}  // namespace gonio

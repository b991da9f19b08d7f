// SPDX-License-Identifier: Apache-2.0
// A table that is looked up at directions gives its samples back, and between them approaches the
// model it was made of at the order of its interpolation, also across poles and seams.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gonio/material.hpp"
#include "grid/rusinkiewicz.hpp"
#include "output/grid_coordinates.hpp"
#include "output/lookup.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using test::TemporaryDirectory;

constexpr auto nearest = Interpolation::nearest;
constexpr auto linear = Interpolation::linear;
constexpr auto cubic = Interpolation::cubic;

Material microfacets(double alpha_x, double alpha_y)
{
    Lobe lobe = default_lobe("ggx");
    lobe.set("alpha_x", std::vector{alpha_x});
    lobe.set("alpha_y", std::vector{alpha_y});
    return {"m", {lobe}};
}

/// The reference over a grid; 0 below the horizon, as kernels give it.
Table tabulated(const Material& material, const Grid& grid)
{
    Table table;
    table.header.quantity = "brdf";
    table.header.unit = "1/sr";
    table.header.axes = grid.axes;
    table.header.channels = {"Y"};
    table.header.single_precision = false;
    const auto f = make_reference(material, Measure::brdf);
    const GridVectors vectors(grid);
    auto& plane = table.values.emplace_back();
    for (std::size_t k = 0; k < table.header.cells(); ++k) {
        const auto length = table.header.row_length();
        const auto [l, v] = vectors.at(k / length, k % length);
        plane.push_back(l.z > 0 && v.z > 0 ? f(l, v, 0) : 0);
    }
    return table;
}

double at(const Table& table, const DirectionPair& pair, Interpolation how)
{
    const auto kind = grid_kind_of(table.header).value();
    return Lookup(table, how).at(grid_coordinates(kind, pair)).front();
}

/// The pair of a grid's cell, its angles found from the vectors where the grid has others.
DirectionPair pair_at(const Grid& grid, std::size_t cell)
{
    const auto length = grid.axes.back().values.size();
    if (grid.kind == GridKind::rusinkiewicz) {
        const auto [l, v] = GridVectors(grid).at(cell / length, cell % length);
        const auto theta = [](glm::dvec3 w) {
            return std::atan2(std::hypot(w.x, w.y), w.z) * 180 / std::numbers::pi;
        };
        const auto phi = [](glm::dvec3 w) { return std::atan2(w.y, w.x) * 180 / std::numbers::pi; };
        return {theta(l), phi(l), theta(v), phi(v)};
    }
    std::vector<double> angles;
    for (std::size_t a = grid.axes.size(); a-- > 0;) {
        const auto& values = grid.axes[a].values;
        angles.insert(angles.begin(), values[cell % values.size()]);
        cell /= values.size();
    }
    if (grid.kind == GridKind::isotropic) return {angles[0], 0, angles[1], angles[2]};
    return {angles[0], angles[1], angles[2], angles[3]};
}

std::vector<Grid> grids(std::size_t n)
{
    std::vector<Grid> all;
    for (const auto samples : {Samples::centre, Samples::node}) {
        all.push_back(isotropic_grid(n, n, 2 * n, samples));
        all.push_back(isotropic_grid(n, n, n, samples, 180));
        all.push_back(rusinkiewicz_grid(n, n, n, samples));
        all.push_back(rusinkiewicz_grid(n, n, n, samples, Spacing::merl));
    }
    return all;
}

std::string name_of(const Grid& grid)
{
    const auto& last = grid.axes.back();
    return grid.axes.front().name + (last.samples == Samples::node ? ", nodes" : ", centres") +
           ", to " + std::to_string(last.values.back());
}

void expect_samples(const Grid& grid, const Table& table, std::size_t step)
{
    const double rounding = grid.kind == GridKind::rusinkiewicz ? 1e-9 : 0;
    for (std::size_t cell = 0; cell < table.header.cells(); cell += step) {
        const auto pair = pair_at(grid, cell);
        if (pair.theta_i > 90 || pair.theta_o > 90) continue;
        const double expected = table.values[0][cell];
        if (grid.kind == GridKind::rusinkiewicz && !(expected > 0)) continue;
        for (const auto how : {nearest, linear, cubic}) {
            EXPECT_NEAR(at(table, pair, how), expected, rounding * expected)
                << name_of(grid) << ", cell " << cell;
        }
    }
}

TEST(LookupGrids, EveryFormatGivesTheSamplesOfEveryGrid)
{
    const TemporaryDirectory directory;
    auto all = grids(7);
    all.push_back(anisotropic_grid(3, 5, 4, 6, Samples::centre));
    all.push_back(anisotropic_grid(3, 5, 4, 7, Samples::node));
    for (const auto& grid : all) {
        const bool round = grid.kind == GridKind::anisotropic;
        auto table = tabulated(microfacets(0.3, round ? 0.5 : 0.3), grid);
        for (auto& value : table.values[0]) value = static_cast<float>(value);
        table.header.single_precision = true;
        for (const std::string format : {"exr", "npy", "csv"}) {
            const auto path = directory / ("table." + format);
            write_table(path, format, table);
            expect_samples(grid, read_table(path), 1);
        }
    }
}

TEST(LookupGrids, MerlFilesGiveTheirSamples)
{
    const TemporaryDirectory directory;
    const auto grid = rusinkiewicz_grid(90, 90, 180, Samples::centre, Spacing::merl);
    write_table(directory / "m.binary", "merl", tabulated(microfacets(0.1, 0.1), grid));
    expect_samples(grid, read_table(directory / "m.binary"), 1009);
}

/// The root mean square error over random pairs with theta_i up to greatest_i.
double error_of(const Table& table, const Material& material, Interpolation how, double greatest_i,
                double greatest_o)
{
    const auto f = make_reference(material, Measure::brdf);
    const Lookup lookup(table, how);
    const auto kind = grid_kind_of(table.header).value();
    std::mt19937_64 random(17);
    const auto uniform = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    double squares = 0;
    for (int k = 0; k < 2000; ++k) {
        const DirectionPair pair{uniform(0, greatest_i), uniform(-720, 720), uniform(0, greatest_o),
                                 uniform(-720, 720)};
        const auto [l, v] = unit_vectors(pair);
        const double error = lookup.at(grid_coordinates(kind, pair)).front() - f(l, v, 0);
        squares += error * error;
    }
    return std::sqrt(squares);
}

/// Halving the cells divides the error by 2, 4, 8: at least by 1.7, 3.4, 6 on these grids.
void expect_orders(const Material& material, const Grid& coarse, const Grid& fine)
{
    const double theta = coarse.kind == GridKind::rusinkiewicz ? 50 : 60;
    const auto coarse_table = tabulated(material, coarse), fine_table = tabulated(material, fine);
    for (const double greatest_i : {theta, 3.0}) {  // anywhere, and within a cell of the normal
        for (const auto& [how, factor] : {std::pair{nearest, 1.7}, {linear, 3.4}, {cubic, 6.0}}) {
            const double before = error_of(coarse_table, material, how, greatest_i, theta);
            const double after = error_of(fine_table, material, how, greatest_i, theta);
            EXPECT_GT(before / after, factor)
                << name_of(coarse) << ", theta_i to " << greatest_i << ", factor " << factor << ": "
                << before << " to " << after;
        }
    }
}

TEST(LookupGrids, InterpolationConvergesAtItsOrder)
{
    const auto coarse = grids(24), fine = grids(48);
    for (std::size_t k = 0; k < coarse.size(); ++k) {
        expect_orders(microfacets(0.7, 0.7), coarse[k], fine[k]);
    }
}

TEST(LookupGrids, InterpolationConvergesOnAnisotropicGrids)
{
    for (const auto samples : {Samples::centre, Samples::node}) {
        expect_orders(microfacets(0.7, 1), anisotropic_grid(12, 24, 12, 24, samples),
                      anisotropic_grid(24, 48, 24, 48, samples));
    }
}

/// A constant is interpolated exactly if nothing from below the horizon takes part.
TEST(LookupGrids, NothingFromBelowTheHorizonTakesPart)
{
    const Material material{"m", {default_lobe("lambert")}};
    for (const auto samples : {Samples::centre, Samples::node}) {
        auto table = tabulated(material, rusinkiewicz_grid(20, 20, 36, samples));
        for (const bool missing : {false, true}) {
            for (auto& value : table.values[0]) {
                if (missing && value == 0) value = std::numeric_limits<double>::quiet_NaN();
            }
            for (const auto how : {nearest, linear, cubic}) {
                for (double theta = 0; theta <= 88; theta += 2.2) {
                    for (double phi = 0; phi < 360; phi += 7) {
                        const double got = at(table, {theta, 10, 88 - 0.3 * theta, phi}, how);
                        EXPECT_NEAR(got, 0.5 / std::numbers::pi, 1e-12) << theta << " " << phi;
                    }
                }
            }
        }
    }
}

TEST(LookupGrids, TheAnglesOfRusinkiewiczAreThoseOfTheGrid)
{
    const auto grid = rusinkiewicz_grid(40, 40, 40, Samples::centre, Spacing::merl);
    const GridVectors vectors(grid);
    for (std::size_t cell = 0; cell < 64000; cell += 7) {
        const auto [l, v] = vectors.at(cell / 40, cell % 40);
        if (l.z <= 1e-3 || v.z <= 1e-3) continue;
        const auto [theta_h, theta_d, phi_d] = rusinkiewicz_angles(pair_at(grid, cell));
        EXPECT_NEAR(theta_h, grid.axes[0].values[cell / 1600], 1e-11);
        EXPECT_NEAR(theta_d, grid.axes[1].values[cell / 40 % 40], 1e-11);
        // Rounding turns an azimuth about a pole that is 0.014 degrees away by 2e-9 degrees.
        EXPECT_NEAR(std::remainder(phi_d - grid.axes[2].values[cell % 40], 360), 0, 1e-8);
    }
}

TEST(LookupGrids, HoldsTheLastCentreUpToTheHorizon)
{
    const auto table =
        tabulated(microfacets(0.5, 0.5), isotropic_grid(10, 10, 20, Samples::centre));
    for (const auto how : {nearest, linear, cubic}) {
        EXPECT_EQ(at(table, {90, 0, 45.5, 99}, how), at(table, {85.5, 0, 45.5, 99}, how));
        EXPECT_EQ(at(table, {30, 0, 90, 99}, how), at(table, {30, 0, 85.5, 99}, how));
    }
}

}  // namespace
}  // namespace gonio

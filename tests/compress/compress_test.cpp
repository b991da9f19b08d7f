// SPDX-License-Identifier: Apache-2.0
// A fitted lobe with its residual gives a table back; the fit finds a lobe that is there.
#include "compress/compress.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "compress/fit.hpp"
#include "gonio/errors.hpp"
#include "gonio/grid.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

/// The reference of a material over a Rusinkiewicz grid.
Table tabulated(const Material& material, const Grid& grid)
{
    Table table;
    table.header.quantity = "brdf";
    table.header.unit = "1/sr";
    table.header.axes = grid.axes;
    table.header.channels = material.channel_names();
    const auto f = make_reference(material, Measure::brdf);
    const GridVectors vectors(grid);
    const auto length = table.header.row_length();
    for (std::size_t c = 0; c < material.channels(); ++c) {
        auto& plane = table.values.emplace_back();
        for (std::size_t k = 0; k < table.header.cells(); ++k) {
            const auto [l, v] = vectors.at(k / length, k % length);
            plane.push_back(l.z > 0 && v.z > 0 ? f(l, v, c) : 0);
        }
    }
    return table;
}

Material material(const std::string& model, const std::string& name, std::vector<double> numbers)
{
    Lobe lobe = default_lobe(model);
    lobe.set(name, numbers);
    return {model, {lobe}};
}

double number(const Lobe& lobe, const std::string& name, std::size_t channel = 0)
{
    return lobe.values[lobe.model->index_of(name)][channel];
}

TEST(Compress, FindsALobeThatIsThere)
{
    for (const double alpha : {0.03, 0.6}) {
        Material made = material("lebedev", "k_d", {0.1, 0.3});
        made.lobes[0].set("k_s", std::vector{0.6, 0.05});
        made.lobes[0].set("alpha", std::vector{alpha});
        const auto grid = rusinkiewicz_grid(24, 16, 12, Samples::centre, Spacing::merl);
        const Lobe found = fit_lobe(tabulated(made, grid));
        EXPECT_NEAR(number(found, "alpha"), alpha, 1e-4 * alpha);
        EXPECT_NEAR(number(found, "k_d", 0), 0.1, 1e-4);
        EXPECT_NEAR(number(found, "k_d", 1), 0.3, 1e-4);
        EXPECT_NEAR(number(found, "k_s", 0), 0.6, 1e-4);
        EXPECT_NEAR(number(found, "k_s", 1), 0.05, 1e-4);
    }
}

/// With the residual of any other model the samples give that model back.
TEST(Compress, ResidualGivesTheTableBack)
{
    const test::TemporaryDirectory directory;
    for (const std::string model : {"oren_nayar", "beckmann"})
        for (const auto samples : {Samples::centre, Samples::node})
            for (const std::size_t azimuths : {12U, 13U}) {
                const auto grid = rusinkiewicz_grid(12, 10, azimuths, samples);
                const Table table = tabulated({model, {default_lobe(model)}}, grid);
                for (const auto& [name, format, error, bound] :
                     {std::tuple{"r.npy", "npy", 0.0, 2e-6}, {"r.exr", "exr", 1e-3, 1e-3}}) {
                    const auto path = directory / name;
                    write_table(path, format, compress(table, "t", error));
                    Lobe lobe = default_lobe("lebedev");
                    lobe.set("residual", path.string());
                    const Loss loss = loss_of(lobe, table);
                    EXPECT_LT(loss.largest, bound) << model << ' ' << azimuths;
                    EXPECT_LE(loss.rms, loss.largest);
                }
            }
}

Table lambert_table(double rho = 0.5)
{
    return tabulated(material("lambert", "rho", {rho}),
                     rusinkiewicz_grid(8, 9, 10, Samples::centre));
}

TEST(Compress, ATableOfFNeedsNoLobe)
{
    const test::TemporaryDirectory directory;
    const auto grid = rusinkiewicz_grid(90, 90, 180, Samples::centre, Spacing::merl);
    const Table table = tabulated(material("ggx", "alpha", {0.2}), grid);
    write_table(directory / "m.binary", "merl", table);
    Lobe lobe = default_lobe("lebedev");
    lobe.set("residual", (directory / "m.binary").string());
    EXPECT_EQ(number(lobe, "k_d"), 1);
    EXPECT_EQ(number(lobe, "k_s"), 0);
    EXPECT_EQ(lobe.channels(), 1U) << "the sidecar says so";
    EXPECT_LT(loss_of(lobe, table).largest, 2e-6);
}

/// What the residual of a table of f says at a place.
double ratio(const Table& table, const DirectionPair& pair)
{
    Lobe lobe = default_lobe("lebedev");
    lobe.set("k_d", std::vector{1.0});
    lobe.set("k_s", std::vector{0.0});
    lobe.tables.resize(lobe.values.size());
    lobe.tables.back() = std::make_shared<const ResidualGrid>(residual_of(table, "t"));
    const auto [l, v] = unit_vectors(pair);
    return make_reference({"", {lobe}}, Measure::brdf)(l, v, 0);
}

/// Zero and negative values have no logarithm; they count as 1e-15 of the greatest.
TEST(Compress, ValuesThatAreNotPositiveCountAsTheLeastOne)
{
    Table table = lambert_table(0.25 * std::numbers::pi);
    for (const double value : {0.0, -3.0, 1e-17}) {
        std::fill(table.values[0].begin() + 90, table.values[0].end(), value);
        EXPECT_NEAR(ratio(table, {70, 0, 10, 180}), 0.25e-15, 2e-3 * 0.25e-15) << value;
        EXPECT_NEAR(ratio(table, {5, 0, 5, 180}), 0.25, 1e-6);
    }
    std::fill(table.values[0].begin(), table.values[0].end(), 0.0);
    EXPECT_THROW(residual_of(table, "t"), UsageError);
}

/// MERL's -1 is NaN here. From some theta_d to the horizon it is no fault; a hole is one.
TEST(Compress, MissingValuesAreAllowedBeforeTheHorizonOnly)
{
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    const std::size_t azimuths = 10, differences = 9;
    Table table = lambert_table(0.25 * std::numbers::pi);
    const auto set = [&](std::size_t h, std::size_t d, double value) {
        for (std::size_t k = 0; k < azimuths; ++k)
            table.values[0][(h * differences + d) * azimuths + k] = value;
    };
    set(1, 8, nothing);
    set(1, 7, nothing);
    EXPECT_NEAR(ratio(table, {70, 0, 80, 95}), 0.25, 1e-6);
    set(1, 5, nothing);
    EXPECT_THROW(residual_of(table, "t"), UsageError);
    EXPECT_THROW(compress(table, "t", 0), UsageError);
    set(1, 5, HUGE_VAL);
    EXPECT_THROW(residual_of(table, "t"), UsageError);
}

std::string message(const Table& table)
{
    try {
        residual_of(table, "name");
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Compress, RefusesWhatItCannotRead)
{
    const Material lambert{"lambert", {default_lobe("lambert")}};
    EXPECT_EQ(message(lambert_table()), "");
    Table table = lambert_table();
    table.header.axes[2].values.back() += 3;
    EXPECT_THAT(message(table), HasSubstr("name: `phi_d` is spaced otherwise; a residual is"));
    table = tabulated(lambert, rusinkiewicz_grid(8, 8, 16, Samples::centre));
    table.header.axes[2].values.resize(12);
    EXPECT_THAT(message(table), HasSubstr("`phi_d` ends at"));
    table = tabulated(lambert, isotropic_grid(8, 8, 8, Samples::centre));
    EXPECT_THAT(message(table), HasSubstr("other axes"));
    table = lambert_table();
    table.header.channels = {"a", "b", "c", "d", "e"};
    EXPECT_THAT(message(table), HasSubstr("5 channels"));
    table = lambert_table();
    table.header.quantity = "brdf_cosine";
    EXPECT_THAT(message(table), HasSubstr("holds `brdf_cosine`"));
    EXPECT_THROW(compress(table, "t", 0), UsageError);
    table.header.quantity = residual_quantity;
    EXPECT_THROW(compress(table, "t", 0), UsageError);

    const test::TemporaryDirectory directory;
    test::set_contents(directory / "text", "no table");
    Lobe lobe = default_lobe("lebedev");
    for (const char* name : {"missing.exr", "text"})
        EXPECT_THROW(lobe.set("residual", (directory / name).string()), UsageError);
    EXPECT_THROW(lobe.set("residual", std::vector{1.0}), UsageError);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What `gonio info` says: ranges counted by hand, and every line of the text.
#include "output/describe.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "output/formats.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

Table counted()
{
    Table table{test::swept_header(), {}};
    for (int c = 0; c < 2; ++c) {
        auto& plane = table.values.emplace_back(table.header.cells());
        for (std::size_t k = 0; k < plane.size(); ++k) plane[k] = static_cast<double>(k) - 10 * c;
    }
    table.values[1][0] = std::numeric_limits<double>::quiet_NaN();
    table.values[1][1] = std::numeric_limits<double>::infinity();
    return table;
}

TEST(Describe, FindsRangesInEveryFormat)
{
    test::TemporaryDirectory directory;
    for (const std::string format : {"exr", "npy", "csv"}) {
        write_table(directory / "table", format, counted());
        const auto got = describe(directory / "table");
        EXPECT_EQ(got.format, format);
        EXPECT_EQ(got.ranges[0].min, 0);
        EXPECT_EQ(got.ranges[0].max, 209);
        EXPECT_DOUBLE_EQ(got.ranges[0].mean, 104.5);
        EXPECT_EQ(got.ranges[0].not_finite, 0u);
        EXPECT_EQ(got.ranges[1].min, -8);
        EXPECT_EQ(got.ranges[1].max, 199);
        EXPECT_EQ(got.ranges[1].not_finite, 2u);
    }
}

TEST(Describe, GoesThroughTablesOfManyBlocks)
{
    test::TemporaryDirectory directory;
    auto header = test::small_header();
    header.axes[0].values.clear();
    for (int k = 0; k < 30'000; ++k) header.axes[0].values.push_back(k);
    Table table{header, {}};
    for (int c = 0; c < 2; ++c) {
        auto& plane = table.values.emplace_back(header.cells());
        for (std::size_t k = 0; k < plane.size(); ++k) plane[k] = static_cast<double>(k);
    }
    ASSERT_GT(header.rows(), 2 * block_rows(header));
    write_table(directory / "table", "npy", table);
    const auto range = describe(directory / "table").ranges[1];
    EXPECT_EQ(range.max, static_cast<double>(header.cells() - 1));
    EXPECT_EQ(range.mean, static_cast<double>(header.cells() - 1) / 2);
}

TEST(Describe, IsReadableByPeople)
{
    test::TemporaryDirectory directory;
    write_table(directory / "table", "exr", counted());
    EXPECT_EQ(text_of(describe(directory / "table")),
              R"(format         exr
quantity       brdf [1/sr]
values         2 x 5 x 3 x 7 cells of float32
swept alpha    2 nodes, evenly spaced from 0.1 to 0.4
axis theta_i   5 cell centres, evenly spaced from 9 to 81 deg
axis theta_o   3 nodes at 0 0.1 90 deg
axis delta_phi 7 cell centres, evenly spaced from 12.857142857142858 to 167.14285714285714 deg
rows           theta_i (outer), theta_o
columns        delta_phi
texels         texel k of n is sample k of its axis, at a cell centre or a node as the axis says: its texture coordinate is (k + 0.5)/n
channel R      min 0, max 209, mean 104.5
channel G      min -8, max 199, mean 95.5, 2 not finite
model          ward
alpha          0.1
rho_s          [0.9,0.3333333333333333]
citation       Ward, "Measuring", 1992, eq. 5a
seed           1.0
)");
}

TEST(Describe, IsReadableByPrograms)
{
    test::TemporaryDirectory directory;
    write_table(directory / "table", "exr", counted());
    const auto json = to_json(describe(directory / "table"));
    EXPECT_EQ(json.at("format"), "exr");
    EXPECT_EQ(json.at("table").at("axes").at(3).at("name"), "delta_phi");
    EXPECT_EQ(json.at("ranges").at("G").at("not_finite"), 2);
}

}  // namespace
}  // namespace gonio

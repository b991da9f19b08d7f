// SPDX-License-Identifier: Apache-2.0
// What holds for every format: round trips, streaming, determinism, broken files.
#include "output/formats.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "gonio/errors.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using test::contents;
using test::filled;
using testing::HasSubstr;

class EveryFormat : public testing::TestWithParam<std::string> {
protected:
    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "table.data";
};

INSTANTIATE_TEST_SUITE_P(All, EveryFormat, testing::Values("exr", "npy", "csv"),
                         [](const auto& format) { return format.param; });

TEST_P(EveryFormat, KeepsHeaderAndValuesExactly)
{
    for (const auto& header : {test::small_header(), test::swept_header()}) {
        const auto table = filled(header);
        write_table(path, GetParam(), table);
        const auto got = read_table(path);
        test::expect_equal(got.header, header);
        EXPECT_EQ(got.values, table.values);
        test::expect_equal(read_header(path), header);
    }
}

TEST_P(EveryFormat, KeepsATableOfOneCellWithoutAxes)
{
    Table table;
    table.header.quantity = "albedo";
    table.header.unit = "1";
    table.header.channels = {"Y"};
    table.values = {{0.25}};
    write_table(path, GetParam(), table);
    EXPECT_EQ(read_table(path).values, table.values);
}

TEST_P(EveryFormat, WritesTheSameBytesInPiecesAsAtOnce)
{
    const auto table = filled(test::swept_header());
    write_table(path, GetParam(), table);
    const auto whole = contents(path);
    for (const auto rows_at_once : {1u, 2u, 7u, 29u}) {
        test::write_in_pieces(path, GetParam(), table, rows_at_once);
        EXPECT_EQ(contents(path), whole) << rows_at_once << " rows at once";
    }
}

TEST_P(EveryFormat, ShowsNothingBeforeItIsFinished)
{
    const auto table = filled(test::small_header());
    {
        const auto writer = make_writer(path, GetParam(), table.header);
        writer->write(Rows<double>{0, 1, {table.values[0].data(), table.values[1].data()}});
        EXPECT_FALSE(std::filesystem::exists(path));
        EXPECT_THROW(writer->finish(), RunError);
    }
    EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST_P(EveryFormat, RefusesRowsOutOfOrder)
{
    const auto table = filled(test::small_header());
    const auto writer = make_writer(path, GetParam(), table.header);
    const std::vector<const double*> planes = {table.values[0].data(), table.values[1].data()};
    EXPECT_THROW(writer->write(Rows<double>{1, 1, planes}), RunError);
    EXPECT_THROW(writer->write(Rows<double>{0, 16, planes}), RunError);
    EXPECT_THROW(writer->write(Rows<double>{0, 1, {planes[0]}}), RunError);
}

TEST_P(EveryFormat, EveryTruncationIsAnErrorWithThePath)
{
    write_table(path, GetParam(), filled(test::small_header()));
    const auto whole = contents(path);
    for (std::size_t size = 0; size + 1 < whole.size(); size += 1 + size / 20) {
        test::set_contents(path, whole.substr(0, size));
        try {
            read_table(path);
            ADD_FAILURE() << "read " << size << " of " << whole.size() << " bytes";
        } catch (const std::runtime_error& fault) {
            EXPECT_THAT(fault.what(), HasSubstr(path.string()));
        }
    }
}

/// A flipped bit may give another value, but never anything other than our two errors.
TEST_P(EveryFormat, FlippedBitsAreReadOrRefused)
{
    write_table(path, GetParam(), filled(test::small_header()));
    const auto whole = contents(path);
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        auto broken = whole;
        for (int flips = 1 + round % 3; flips > 0; --flips) {
            broken[random() % broken.size()] ^= static_cast<char>(1u << (random() % 8));
        }
        test::set_contents(path, broken);
        try {
            read_table(path);
        } catch (const RunError& fault) {
            EXPECT_THAT(fault.what(), HasSubstr(path.string()));
        } catch (const UsageError& fault) {
            EXPECT_THAT(fault.what(), HasSubstr(path.string()));
        }
    }
}

TEST_P(EveryFormat, KeepsWhatIsNotFinite)
{
    auto table = filled(test::small_header());
    table.values[0][3] = std::numeric_limits<double>::infinity();
    table.values[1][5] = std::numeric_limits<double>::quiet_NaN();
    write_table(path, GetParam(), table);
    const auto got = read_table(path);
    EXPECT_EQ(got.values[0][3], table.values[0][3]);
    EXPECT_TRUE(std::isnan(got.values[1][5]));
}

TEST(FileFormats, OnesThatHoldDoublesKeepThem)
{
    test::TemporaryDirectory directory;
    auto header = test::small_header();
    header.single_precision = false;
    const auto table = filled(header);
    for (const auto* format : {"npy", "csv"}) {
        write_table(directory / format, format, table);
        const auto got = read_table(directory / format);
        EXPECT_FALSE(got.header.single_precision);
        EXPECT_EQ(got.values, table.values) << format;
    }
}

TEST(FileFormats, UnknownOnesAreRefused)
{
    test::TemporaryDirectory directory;
    EXPECT_THROW(make_writer(directory / "a.tiff", "tiff", test::small_header()), UsageError);
    test::set_contents(directory / "a.tiff", "II*");
    EXPECT_THROW(read_table(directory / "a.tiff"), UsageError);
    test::set_contents(directory / "empty", "");
    EXPECT_THROW(read_table(directory / "empty"), UsageError);
    EXPECT_THROW(read_table(directory / "missing"), RunError);
    EXPECT_THROW(read_table(directory.path()), RunError);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// MERL's .binary against its layout worked out by hand, and files of others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "gonio/errors.hpp"
#include "gonio/table.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

constexpr std::size_t planes_begin = 12;
constexpr std::size_t plane_cells = std::size_t{90} * 90 * 180;

TableHeader merl_header(const std::vector<std::string>& channels)
{
    TableHeader header;
    header.quantity = "brdf";
    header.unit = "1/sr";
    header.axes = {{"theta_h", "deg", {}, Samples::centre},
                   {"theta_d", "deg", {}, Samples::centre},
                   {"phi_d", "deg", {}, Samples::centre}};
    for (int k = 0; k < 90; ++k) header.axes[0].values.push_back((k + 0.5) * (k + 0.5) / 90);
    for (int k = 0; k < 90; ++k) header.axes[1].values.push_back(k + 0.5);
    for (int k = 0; k < 180; ++k) header.axes[2].values.push_back(k + 0.5);
    header.channels = channels;
    header.attributes = {{"model", "ggx"}};
    return header;
}

double stored(const std::string& bytes, std::size_t plane, std::size_t h, std::size_t d,
              std::size_t p)
{
    double value = 0;
    const auto cell = plane * plane_cells + p + 180 * (d + 90 * h);
    std::memcpy(&value, bytes.data() + planes_begin + cell * sizeof value, sizeof value);
    return value;
}

/// A file as others write them: sizes, then three planes of one value.
std::string foreign(const std::array<std::int32_t, 3>& sizes, double value)
{
    std::string bytes(reinterpret_cast<const char*>(sizes.data()), sizeof sizes);
    const auto cells = static_cast<std::size_t>(3 * sizes[0] * sizes[1] * sizes[2]);
    const std::vector<double> values(cells, value);
    return bytes.append(reinterpret_cast<const char*>(values.data()), cells * sizeof(double));
}

class Merl : public testing::Test {
protected:
    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "table.binary";
};

TEST_F(Merl, StoresCellsWhereItsReadersLook)
{
    auto table = test::filled(merl_header({"R", "G", "B"}));
    test::write_in_pieces(path, "merl", table, 1001);
    const auto bytes = test::contents(path);
    ASSERT_EQ(bytes.size(), planes_begin + 3 * plane_cells * 8);
    EXPECT_EQ(bytes.substr(0, 12), std::string("\x5a\0\0\0\x5a\0\0\0\xb4\0\0\0", 12));
    const std::size_t cell = (std::size_t{10} * 90 + 20) * 180 + 30;
    EXPECT_DOUBLE_EQ(stored(bytes, 0, 10, 20, 30), table.values[0][cell] * 1500);
    EXPECT_DOUBLE_EQ(stored(bytes, 1, 10, 20, 30), table.values[1][cell] * 1500 / 1.15);
    EXPECT_DOUBLE_EQ(stored(bytes, 2, 10, 20, 30), table.values[2][cell] * 1500 / 1.66);
}

// theta_h bin 80 is centred on 80.5^2/90 = 72.003 degrees. With theta_d = 18.5 and phi_d = 0.5 one
// direction is at 72.003 + 18.5 > 90; with theta_d = 17.5 it is at 89.503; and where phi_d = 89.5
// the direction is tilted sideways and stays above.
TEST_F(Merl, MarksCellsBelowTheHorizon)
{
    write_table(path, "merl", test::filled(merl_header({"R", "G", "B"})));
    const auto bytes = test::contents(path);
    EXPECT_EQ(stored(bytes, 0, 80, 18, 0), -1);
    EXPECT_EQ(stored(bytes, 2, 80, 18, 0), -1);
    EXPECT_EQ(stored(bytes, 0, 80, 18, 179), -1);
    EXPECT_GT(stored(bytes, 0, 80, 17, 0), 0);
    EXPECT_GT(stored(bytes, 0, 80, 18, 89), 0);
    EXPECT_TRUE(std::isnan(read_table(path).values[0][std::size_t{80 * 90 + 18} * 180]));
}

TEST_F(Merl, KeepsHeaderAndValues)
{
    for (const auto& channels : {std::vector<std::string>{"R", "G", "B"}, {"Y"}}) {
        const auto table = test::filled(merl_header(channels));
        write_table(path, "merl", table);
        const auto got = read_table(path);
        test::expect_equal(got.header, table.header);
        for (std::size_t c = 0; c < channels.size(); ++c) {
            for (std::size_t k = 0; k < plane_cells; ++k) {
                if (std::isnan(got.values[c][k])) continue;
                ASSERT_EQ(got.values[c][k], table.values[c][k]) << c << ' ' << k;
            }
        }
    }
}

TEST_F(Merl, WritesOneChannelToAllPlanes)
{
    auto table = test::filled(merl_header({"Y"}));
    write_table(path, "merl", table);
    std::filesystem::remove(directory / "table.json");
    const auto got = read_table(path);
    EXPECT_EQ(got.header.channels, (std::vector<std::string>{"R", "G", "B"}));
    for (const auto& plane : got.values) EXPECT_DOUBLE_EQ(plane[12345], table.values[0][12345]);
}

TEST_F(Merl, RefusesEveryOtherTable)
{
    EXPECT_NO_THROW(make_writer(path, "merl", merl_header({"Y"})));
    EXPECT_THROW(make_writer(path, "merl", test::small_header()), UsageError);
    EXPECT_THROW(make_writer(path, "merl", merl_header({"R", "G"})), UsageError);
    auto linear = merl_header({"Y"});
    linear.axes[0].values = linear.axes[1].values;
    EXPECT_THROW(make_writer(path, "merl", linear), UsageError);
    auto nodes = merl_header({"Y"});
    nodes.axes[2].samples = Samples::node;
    EXPECT_THROW(make_writer(path, "merl", nodes), UsageError);
    try {
        make_writer(path, "merl", test::small_header());
    } catch (const UsageError& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("90 x 90 x 180 values over theta_h, theta_d, phi_d"));
    }
}

TEST_F(Merl, ReadsFilesOfOthersInAnySize)
{
    test::set_contents(path, foreign({2, 3, 4}, 1500));
    const auto table = read_table(path);
    EXPECT_EQ(table.header.axes[0].values, (std::vector<double>{5.625, 50.625}));
    EXPECT_EQ(table.header.axes[1].values, (std::vector<double>{15, 45, 75}));
    EXPECT_EQ(table.header.axes[2].values, (std::vector<double>{22.5, 67.5, 112.5, 157.5}));
    EXPECT_DOUBLE_EQ(table.values[0][23], 1);
    EXPECT_DOUBLE_EQ(table.values[1][23], 1.15);
    EXPECT_DOUBLE_EQ(table.values[2][23], 1.66);
}

TEST_F(Merl, RefusesFilesOfAnotherSizeThanTheySay)
{
    const auto whole = foreign({2, 3, 4}, 1);
    for (const auto& bytes :
         {whole.substr(0, whole.size() - 8), whole + "x", whole.substr(0, 12)}) {
        test::set_contents(path, bytes);
        EXPECT_THROW(read_table(path), RunError) << bytes.size();
    }
    test::set_contents(path, whole.substr(0, 11));
    EXPECT_THROW(read_table(path), UsageError);
    test::set_contents(path, foreign({0, 3, 4}, 1));
    EXPECT_THROW(read_table(path), UsageError);
    test::set_contents(path, foreign({2, 3, 4}, 1).replace(0, 12, "0123456789ab"));
    EXPECT_THROW(read_table(path), UsageError);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What is particular to CSV: its text, and errors that name file:line:column.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "gonio/errors.hpp"
#include "gonio/table.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

class Csv : public testing::Test {
protected:
    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "table.csv";

    static Table tiny()
    {
        Table table;
        table.header.quantity = "brdf";
        table.header.unit = "1/sr";
        table.header.axes = {{"theta_i", "deg", {0, 90}, Samples::node},
                             {"theta_o", "deg", {22.5, 67.5}, Samples::centre}};
        table.header.channels = {"R", "G"};
        table.header.attributes = {{"model", "ward"}, {"alpha", 0.1}};
        table.values = {{1, 0.1, 1e-7, 3}, {2, 2.5, 1e9, 4}};
        return table;
    }

    void expect_fault(const std::string& text, const std::string& message)
    {
        test::set_contents(path, text);
        try {
            read_table(path);
            ADD_FAILURE() << "no fault, expected: " << message;
        } catch (const UsageError& fault) {
            EXPECT_THAT(fault.what(), HasSubstr(path.string() + message));
        }
    }
};

TEST_F(Csv, IsWhatItsReadersExpect)
{
    write_table(path, "csv", tiny());
    EXPECT_EQ(test::contents(path), R"(# gonio table 1
# quantity: "brdf"
# unit: "1/sr"
# precision: "float32"
# sweep_axes: 0
# channels: ["R","G"]
# axis: {"name":"theta_i","unit":"deg","samples":"node","values":[0.0,90.0]}
# axis: {"name":"theta_o","unit":"deg","samples":"centre","values":[22.5,67.5]}
# attribute: {"model":"ward"}
# attribute: {"alpha":0.1}
theta_i,theta_o,R,G
deg,deg,1/sr,1/sr
0,22.5,1,2
0,67.5,0.1,2.5
90,22.5,1e-07,1000000000
90,67.5,3,4
)");
}

TEST_F(Csv, FaultsAreWhereTheyAre)
{
    write_table(path, "csv", tiny());
    const auto whole = test::contents(path);
    const auto changed = [&](const std::string& from, const std::string& to) {
        auto text = whole;
        return text.replace(text.find(from), from.size(), to);
    };
    expect_fault(changed("0.1,2.5", "0.1,2.5x"), ":14:12: '2.5x' is not a number");
    expect_fault(changed("0.1,2.5", "0.1,"), ":14:12: '' is not a number");
    expect_fault(changed("1e-07", "1e-99"), ":15:9: '1e-99' is out of range");
    expect_fault(changed("90,67.5", "90,66.5"), ":16:4: expected theta_o = 67.5");
    expect_fault(changed("0.1,2.5", "0.1"), ":14:1: expected 4 fields, not 3");
    expect_fault(changed("theta_i,theta_o,R", "theta_i,R"),
                 ":11:1: expected 'theta_i,theta_o,R,G'");
    expect_fault(changed("deg,deg", "rad,deg"), ":12:1: expected 'deg,deg,1/sr");
    expect_fault(whole + "0,22.5,1,2\n", ":17:1: more than the 4 cells of the table");
}

TEST_F(Csv, AsksForNoMemoryThatItCannotFill)
{
    write_table(path, "csv", tiny());
    auto text = test::contents(path);
    std::string values = "0.0";
    for (int k = 1; k < 3000; ++k) values += ',' + std::to_string(k);
    for (int axis = 0; axis < 2; ++axis) {
        const auto start =
            text.find('[', text.find("\"values\"", axis == 0 ? 0 : text.find("theta_o"))) + 1;
        text.replace(start, text.find(']', start) - start, values);
    }
    test::set_contents(path, text);
    try {
        read_header(path);
        ADD_FAILURE() << "a few lines hold nine million cells";
    } catch (const RunError& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("too short for the 3000 x 3000 cells"));
    }
}

TEST_F(Csv, MayHaveComeThroughWindows)
{
    write_table(path, "csv", tiny());
    std::string text;
    for (const char c : test::contents(path)) text += c == '\n' ? "\r\n" : std::string(1, c);
    test::set_contents(path, text);
    EXPECT_EQ(read_table(path).values[1], tiny().values[1]);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What is particular to .npy: NumPy reads it, the sidecar goes with it and follows its schema.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "gonio/table.hpp"
#include "output/sidecar.hpp"
#include "output/table_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

class Npy : public testing::Test {
protected:
    test::TemporaryDirectory directory;
    std::filesystem::path path = directory / "table.npy";

    std::string python(const std::string& script) { return test::python(script, directory.path()); }
};

TEST_F(Npy, IsReadByNumPy)
{
    auto table = test::filled(test::swept_header());
    write_table(path, "npy", table);
    EXPECT_EQ(python("a = numpy.load('table.npy'); print(a.shape, a.dtype, a.flags.c_contiguous)"),
              "(2, 2, 5, 3, 7) float32 True\n");
    EXPECT_EQ(python("print(repr(float(numpy.load('table.npy')[1, 1, 4, 2, 6])))"),
              fmt::format("{}\n", table.values[1].back()));

    table.header.single_precision = false;
    table.header.channels = {"Y"};
    table.values.pop_back();
    write_table(path, "npy", table);
    EXPECT_EQ(python("a = numpy.load('table.npy'); print(a.shape, a.dtype)"),
              "(2, 5, 3, 7) float64\n");
}

TEST_F(Npy, HasTheBytesThatNumPyWrites)
{
    for (const auto& header : {test::small_header(), test::swept_header()}) {
        write_table(path, "npy", test::filled(header));
        python("numpy.save('again.npy', numpy.load('table.npy'))");
        EXPECT_EQ(test::contents(path), test::contents(directory / "again.npy"));
    }
}

TEST_F(Npy, NeedsItsSidecar)
{
    write_table(path, "npy", test::filled(test::small_header()));
    test::set_contents(directory / "table.json", "{\"somebody\": \"else's\"}");
    EXPECT_THROW(read_table(path), RunError);
    std::filesystem::remove(directory / "table.json");
    try {
        read_table(path);
        ADD_FAILURE() << "read without its axes";
    } catch (const RunError& fault) {
        EXPECT_THAT(fault.what(), HasSubstr((directory / "table.json").string()));
    }
}

TEST_F(Npy, RefusesASidecarOfAnotherTable)
{
    write_table(path, "npy", test::filled(test::small_header()));
    write_sidecar(path, test::swept_header());
    EXPECT_THROW(read_table(path), RunError);
}

TEST_F(Npy, SidecarHoldsARunThatReadersIgnore)
{
    write_table(path, "npy", test::filled(test::small_header()));
    write_sidecar(path, test::small_header(), {{"device", "cpu"}, {"seconds", 0.25}});
    test::expect_equal(read_header(path), test::small_header());
    EXPECT_EQ(python("print(json.load(open('table.json'))['run']['device'])"), "cpu\n");
}

TEST_F(Npy, SidecarFollowsItsSchema)
{
    const auto schema =
        std::filesystem::path(TEST_DATA).parent_path() / "output" / "table.schema.json";
    const auto validate = fmt::format(
        "import jsonschema; jsonschema.validate(json.load(open('table.json')), "
        "json.load(open('{}'))); print('valid')",
        schema.string());
    for (const auto& run : {nlohmann::ordered_json::object(), {{"seconds", 0.25}}}) {
        write_sidecar(path, test::swept_header(), run);
        EXPECT_EQ(python(validate), "valid\n");
    }
    auto text = test::contents(directory / "table.json");
    text.replace(text.find("\"centre\""), 8, "\"middle\"");
    test::set_contents(directory / "table.json", text);
    EXPECT_EQ(python(validate), "") << "the schema accepts what readers refuse";
}

TEST_F(Npy, EveryTruncatedSidecarIsRefused)
{
    write_table(path, "npy", test::filled(test::small_header()));
    const auto whole = test::contents(directory / "table.json");
    for (std::size_t size = 0; size + 2 < whole.size(); size += 7) {
        test::set_contents(directory / "table.json", whole.substr(0, size));
        EXPECT_THROW(read_table(path), RunError) << size;
    }
}

}  // namespace
}  // namespace gonio

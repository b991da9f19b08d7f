// SPDX-License-Identifier: Apache-2.0
// Tables and places for the tests of host/output.
#include "output/table_fixtures.hpp"

#include <Imath/half.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace gonio::test {

TemporaryDirectory::TemporaryDirectory()
{
    std::string name = std::filesystem::temp_directory_path() / "gonio-test-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
}

TemporaryDirectory::~TemporaryDirectory()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

TableHeader small_header()
{
    TableHeader header;
    header.quantity = "brdf";
    header.unit = "1/sr";
    header.axes = {{"theta_i", "deg", {9, 27, 45, 63, 81}, Samples::centre},
                   {"theta_o", "deg", {0, 0.1, 90}, Samples::node},
                   {"delta_phi", "deg", {}, Samples::centre}};
    for (int k = 0; k < 7; ++k) header.axes[2].values.push_back((k + 0.5) * 180 / 7);
    header.channels = {"R", "G"};
    header.attributes = {{"model", "ward"},
                         {"alpha", 0.1},
                         {"rho_s", std::vector<double>{0.9, 1.0 / 3}},
                         {"citation", "Ward, \"Measuring\", 1992, eq. 5a"},
                         {"seed", 1.0}};
    return header;
}

TableHeader swept_header()
{
    auto header = small_header();
    header.axes.insert(header.axes.begin(), {"alpha", "1", {0.1, 0.4}, Samples::node});
    header.sweep_axes = 1;
    return header;
}

Table filled(const TableHeader& header, bool halves)
{
    Table table{header, {}};
    double k = 0;
    for (std::size_t c = 0; c < header.channels.size(); ++c) {
        auto& plane = table.values.emplace_back(header.cells());
        for (auto& value : plane) {
            value = std::exp(5 * std::sin(k++)) / 3;
            if (header.single_precision) value = static_cast<float>(value);
            if (halves) value = static_cast<float>(half(static_cast<float>(value)));
        }
    }
    return table;
}

template <class Real>
static void write_pieces(TableWriter& writer, const Table& table, std::size_t rows_at_once)
{
    std::vector<std::vector<Real>> planes;
    for (const auto& plane : table.values) planes.emplace_back(plane.begin(), plane.end());
    const auto rows = table.header.rows();
    for (std::size_t row = 0; row < rows; row += rows_at_once) {
        Rows<Real> piece{row, std::min(rows_at_once, rows - row), {}};
        for (const auto& plane : planes) {
            piece.planes.push_back(plane.data() + row * table.header.row_length());
        }
        writer.write(piece);
    }
}

void write_in_pieces(const std::filesystem::path& path, const std::string& format,
                     const Table& table, std::size_t rows_at_once, const WriteOptions& options)
{
    const auto writer = make_writer(path, format, table.header, options);
    if (table.header.single_precision) {
        write_pieces<float>(*writer, table, rows_at_once);
    } else {
        write_pieces<double>(*writer, table, rows_at_once);
    }
    writer->finish();
}

std::string contents(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void set_contents(const std::filesystem::path& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

/// Stdout and exit status of a command.
static std::pair<std::string, int> run(const std::string& command)
{
    std::string text;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return {"", -1};
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    const int status = ::pclose(pipe);
    return {text, status};
}

std::string output_of(const std::string& command)
{
    const auto [text, status] = run(command);
    EXPECT_EQ(status, 0) << command;
    return text;
}

std::string python(const std::string& script, const std::filesystem::path& directory)
{
    const auto file = directory / "script.py";
    set_contents(file, "import json\nimport numpy\n" + script + "\n");
    const auto [text, status] =
        run("cd " + directory.string() + " && /usr/bin/python3 script.py 2>/dev/null");
    return status == 0 ? text : "";
}

void expect_equal(const TableHeader& got, const TableHeader& expected)
{
    EXPECT_EQ(got.quantity, expected.quantity);
    EXPECT_EQ(got.unit, expected.unit);
    EXPECT_EQ(got.channels, expected.channels);
    EXPECT_EQ(got.sweep_axes, expected.sweep_axes);
    EXPECT_EQ(got.single_precision, expected.single_precision);
    EXPECT_EQ(got.attributes, expected.attributes);
    ASSERT_EQ(got.axes.size(), expected.axes.size());
    for (std::size_t a = 0; a < got.axes.size(); ++a) {
        EXPECT_EQ(got.axes[a].name, expected.axes[a].name);
        EXPECT_EQ(got.axes[a].unit, expected.axes[a].unit);
        EXPECT_EQ(got.axes[a].samples, expected.axes[a].samples);
        EXPECT_EQ(got.axes[a].values, expected.axes[a].values);
    }
}

}  // namespace gonio::test

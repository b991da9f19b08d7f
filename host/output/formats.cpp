// SPDX-License-Identifier: Apache-2.0
// Chooses the format: by name to write, by content to read.
#include "output/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <fstream>
#include <string_view>
#include <system_error>

#include "gonio/errors.hpp"
#include "output/check.hpp"
#include "output/csv_format.hpp"

namespace gonio {
namespace {

constexpr std::string_view exr_magic = "\x76\x2f\x31\x01";
constexpr std::string_view npy_magic = "\x93NUMPY";

std::string first_bytes(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    const int error = std::filesystem::is_directory(path) ? EISDIR : file ? 0 : errno;
    if (error != 0) {
        throw RunError(fmt::format("{}: cannot be read: {}", path.string(),
                                   std::generic_category().message(error)));
    }
    std::array<char, 16> bytes = {};
    file.read(bytes.data(), bytes.size());
    return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

}  // namespace

std::unique_ptr<TableWriter> make_writer(const std::filesystem::path& path,
                                         const std::string& format, const TableHeader& header,
                                         const WriteOptions& options)
{
    check(header);
    if (format == "exr") return make_exr_writer(path, header, options);
    if (format == "npy") return make_npy_writer(path, header);
    if (format == "csv") return make_csv_writer(path, header);
    if (format == "merl") return make_merl_writer(path, header);
    throw UsageError(fmt::format("the format is exr, npy, csv or merl, not '{}'", format));
}

void write_table(const std::filesystem::path& path, const std::string& format, const Table& table,
                 const WriteOptions& options)
{
    const auto writer = make_writer(path, format, table.header, options);
    Rows<double> rows{0, table.header.rows(), {}};
    for (const auto& plane : table.values) rows.planes.push_back(plane.data());
    writer->write(rows);
    writer->finish();
}

std::string format_of(const std::filesystem::path& path)
{
    const auto bytes = first_bytes(path);
    if (bytes.starts_with(exr_magic)) return "exr";
    if (bytes.starts_with(npy_magic)) return "npy";
    if (bytes.starts_with(csv_first_line)) return "csv";
    if (is_merl(path)) return "merl";
    throw UsageError(
        fmt::format("{}: neither a MERL file nor a table in EXR, npy or CSV", path.string()));
}

std::unique_ptr<TableReader> open_table(const std::filesystem::path& path)
{
    const auto format = format_of(path);
    if (format == "exr") return open_exr(path);
    if (format == "npy") return open_npy(path);
    if (format == "csv") return open_csv(path);
    return open_merl(path);
}

std::size_t block_rows(const TableHeader& header)
{
    constexpr std::size_t block_values = std::size_t{1} << 19;
    return std::max<std::size_t>(1, block_values / header.row_length() / header.channels.size());
}

TableHeader read_header(const std::filesystem::path& path)
{
    return open_table(path)->header();
}

Table read_table(const std::filesystem::path& path)
{
    const auto reader = open_table(path);
    const auto& header = reader->header();
    Table table{header, {}};
    try {
        table.values.assign(header.channels.size(), std::vector<double>(header.cells()));
    } catch (const std::exception&) {  // bad_alloc or length_error
        throw RunError(fmt::format("{}: a table of {} cells does not fit into memory",
                                   path.string(), shape_text(header)));
    }
    const auto rows = header.rows();
    for (std::size_t row = 0; row < rows; row += block_rows(header)) {
        std::vector<double*> planes;
        for (auto& plane : table.values) planes.push_back(&plane[row * header.row_length()]);
        reader->read(std::min(block_rows(header), rows - row), planes);
    }
    return table;
}

}  // namespace gonio

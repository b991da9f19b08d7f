// SPDX-License-Identifier: Apache-2.0
// What the file formats offer to formats.cpp, which chooses among them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "gonio/table.hpp"

namespace gonio {

/// Gives a table's rows in ascending order, as many at a time as the caller has room for.
class TableReader {
public:
    virtual ~TableReader() = default;
    virtual const TableHeader& header() const = 0;
    /// Reads the next `count` rows: planes[channel] has room for count * row_length values.
    /// Throws RunError if the file is truncated or corrupt.
    virtual void read(std::size_t count, const std::vector<double*>& planes) = 0;
};

/// The format of a file by its first bytes: "exr", "npy", "csv" or "merl". RunError if it cannot be
/// read, UsageError if it is none of them.
std::string format_of(const std::filesystem::path& path);

/// Opens a file of any format. Throws as format_of, and RunError if the file is broken.
std::unique_ptr<TableReader> open_table(const std::filesystem::path& path);

/// Rows of a table that make a few MiB of doubles: a good count for read().
std::size_t block_rows(const TableHeader& header);

std::unique_ptr<TableWriter> make_exr_writer(const std::filesystem::path& path,
                                             const TableHeader& header,
                                             const WriteOptions& options);
std::unique_ptr<TableWriter> make_npy_writer(const std::filesystem::path& path,
                                             const TableHeader& header);
std::unique_ptr<TableWriter> make_csv_writer(const std::filesystem::path& path,
                                             const TableHeader& header);

std::unique_ptr<TableWriter> make_merl_writer(const std::filesystem::path& path,
                                              const TableHeader& header);

/// MERL files have no magic number: are the first three numbers possible sizes?
bool is_merl(const std::filesystem::path& path);

std::unique_ptr<TableReader> open_exr(const std::filesystem::path& path);
std::unique_ptr<TableReader> open_npy(const std::filesystem::path& path);
std::unique_ptr<TableReader> open_csv(const std::filesystem::path& path);
std::unique_ptr<TableReader> open_merl(const std::filesystem::path& path);

}  // namespace gonio

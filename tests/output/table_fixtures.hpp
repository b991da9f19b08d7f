// SPDX-License-Identifier: Apache-2.0
// Tables and places for the tests of host/output.
#pragma once

#include <filesystem>
#include <string>

#include "gonio/table.hpp"

namespace gonio::test {

/// A new directory that is removed with all it holds.
class TemporaryDirectory {
public:
    TemporaryDirectory();
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// theta_i (5 centres) x theta_o (uneven: 3 nodes) x delta_phi (7 centres), channels R, G, with
/// attributes of each kind.
TableHeader small_header();

/// The same under a swept axis alpha (2 values), which makes two parts in EXR.
TableHeader swept_header();

/// Values of about eight decades, different in every cell; exactly halves if `halves`.
Table filled(const TableHeader& header, bool halves = false);

/// Writes a table `rows_at_once` rows at a time, as floats if the header says so.
void write_in_pieces(const std::filesystem::path& path, const std::string& format,
                     const Table& table, std::size_t rows_at_once,
                     const WriteOptions& options = {});

std::string contents(const std::filesystem::path& path);
void set_contents(const std::filesystem::path& path, const std::string& bytes);

/// What a command prints on stdout. Expects it to succeed.
std::string output_of(const std::string& command);

/// What a Python script prints, run in `directory` with json and numpy imported; "" if it fails.
std::string python(const std::string& script, const std::filesystem::path& directory);

/// Expects every member to be equal, numbers to the last bit.
void expect_equal(const TableHeader& got, const TableHeader& expected);

}  // namespace gonio::test

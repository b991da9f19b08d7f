// SPDX-License-Identifier: Apache-2.0
// Reads the comma-separated reference numbers of tests/data.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace gonio::test {

/// One row: the text of each named column.
class CsvRow {
public:
    explicit CsvRow(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}

    const std::string& text(const std::string& column) const { return cells_.at(column); }
    double number(const std::string& column) const { return std::stod(text(column)); }

private:
    std::map<std::string, std::string> cells_;
};

/// The rows of a file below tests/data. Lines with # in front are comments; the first other line
/// names the columns.
inline std::vector<CsvRow> read_csv(const std::string& name)
{
    std::ifstream file(std::string(TEST_DATA "/") + name);
    EXPECT_TRUE(file) << "cannot open " << name;
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        std::vector<std::string> cells;
        std::istringstream stream(line + ",");
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = cells.at(i);
        rows.emplace_back(std::move(row));
    }
    return rows;
}

}  // namespace gonio::test

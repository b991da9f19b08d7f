// SPDX-License-Identifier: Apache-2.0
// Reads rows of numbers from a CSV file or from standard input.
#include "commands/row_list.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "gonio/errors.hpp"
#include "output/csv_lines.hpp"

namespace gonio {
namespace {

constexpr double most_turns = 100;  // of an azimuth

std::string listing(const std::vector<Column>& columns)
{
    std::string text;
    for (const Column& column : columns) {
        text += text.empty() ? "" : ", ";
        text += column.name;
        if (column.unit != "1") text += fmt::format(" [{}]", column.unit);
    }
    return text;
}

std::vector<std::vector<double>> read(std::istream& stream, const std::string& name,
                                      const std::vector<Column>& columns)
{
    std::vector<std::vector<double>> rows;
    CsvLines lines(stream, name);
    for (bool first = true; lines.next(); first = false) {
        if (lines.line().empty() || lines.line().starts_with('#')) continue;
        const std::vector<std::string_view> fields = lines.fields();
        if (fields.size() != columns.size())
            lines.fail(fmt::format("{} fields; a row is {}", fields.size(), listing(columns)));
        if (first && fields[0] == columns[0].name) continue;
        std::vector<double>& row = rows.emplace_back();
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const auto& [column, unit, least, greatest] = columns[k];
            row.push_back(lines.number<double>(fields[k]));
            if (!(row[k] >= least && row[k] <= greatest))
                lines.fail(fields[k],
                           fmt::format("`{}` is {}; allowed is {:.9g} to {:.9g}{}", column, row[k],
                                       least, greatest, unit == "1" ? "" : " " + unit));
        }
    }
    return rows;
}

}  // namespace

std::vector<Column> direction_columns()
{
    const double turns = 360 * most_turns;
    return {{"theta_i", "deg", 0, 90},
            {"phi_i", "deg", -turns, turns},
            {"theta_o", "deg", 0, 90},
            {"phi_o", "deg", -turns, turns}};
}

std::vector<std::vector<double>> read_rows(const std::string& path,
                                           const std::vector<Column>& columns)
{
    if (path == "-") return read(std::cin, "standard input", columns);
    std::ifstream file(path);
    if (!file) throw UsageError(fmt::format("{}: cannot be read", path));
    return read(file, path, columns);
}

DirectionPair pair_of(const std::vector<double>& row)
{
    return {row[0], row[1], row[2], row[3]};
}

}  // namespace gonio

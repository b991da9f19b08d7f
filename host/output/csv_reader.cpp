// SPDX-License-Identifier: Apache-2.0
// Reads the tables that csv_writer.cpp wrote; a line that is not the expected cell is an error.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

#include "gonio/errors.hpp"
#include "output/check.hpp"
#include "output/csv_format.hpp"
#include "output/csv_lines.hpp"
#include "output/formats.hpp"
#include "output/table_json.hpp"

namespace gonio {
namespace {

using Json = nlohmann::ordered_json;

class CsvReader final : public TableReader {
public:
    explicit CsvReader(const std::filesystem::path& path)
        : path_(path), stream_(path), lines_(stream_, path.string())
    {
        next_line("the first line");
        Json json = {{"axes", Json::array()}, {"attributes", Json::object()}};
        for (next_line("the names"); lines_.line().starts_with("# "); next_line("the names")) {
            add_comment(json);
        }
        header_ = header_from_json(json, path.string());
        expect(csv_names(header_));
        next_line("the units");
        expect(csv_units(header_));
        index_.assign(header_.axes.size(), 0);
        rows_left_ = header_.rows();
        require_size();
    }

    const TableHeader& header() const override { return header_; }

    void read(std::size_t count, const std::vector<double*>& planes) override
    {
        for (std::size_t cell = 0; cell < count * header_.row_length(); ++cell) {
            next_line("a cell");
            read_cell(cell, planes);
        }
        rows_left_ -= count;
        if (rows_left_ == 0 && lines_.next()) {
            lines_.fail(fmt::format("more than the {} cells of the table", header_.cells()));
        }
    }

private:
    void next_line(const std::string& what)
    {
        if (!lines_.next()) {
            throw RunError(fmt::format("{}: ends where {} should follow", path_.string(), what));
        }
    }

    /// So that no memory is asked for what cannot be there: a cell takes two bytes or more.
    void require_size() const
    {
        if (std::filesystem::file_size(path_) / 2 < header_.cells()) {
            throw RunError(fmt::format("{}: is too short for the {} cells of its header",
                                       path_.string(), shape_text(header_)));
        }
    }

    /// A line "# key: json".
    void add_comment(Json& json) const
    {
        const std::string& line = lines_.line();
        const auto colon = line.find(": ");
        if (colon == std::string::npos) lines_.fail("expected '# key: value'");
        const auto key = line.substr(2, colon - 2);
        const auto value = parse_json(line.substr(colon + 2), path_.string());
        if (key == "axis") {
            json["axes"].push_back(value);
        } else if (key == "attribute" && value.is_object()) {
            json["attributes"].update(value);
        } else {
            json[key] = value;
        }
    }

    void expect(const std::vector<std::string>& words) const
    {
        const auto line = fmt::format("{}", fmt::join(words, ","));
        if (lines_.line() != line) lines_.fail(fmt::format("expected '{}'", line));
    }

    void read_cell(std::size_t cell, const std::vector<double*>& planes)
    {
        const auto fields = lines_.fields();
        const auto axes = header_.axes.size();
        if (fields.size() != axes + planes.size()) {
            lines_.fail(
                fmt::format("expected {} fields, not {}", axes + planes.size(), fields.size()));
        }
        for (std::size_t a = 0; a < axes; ++a) {
            const double expected = header_.axes[a].values[index_[a]];
            if (lines_.number<double>(fields[a]) != expected) {
                lines_.fail(fields[a],
                            fmt::format("expected {} = {}", header_.axes[a].name, expected));
            }
        }
        for (std::size_t c = 0; c < planes.size(); ++c) {
            const auto field = fields[axes + c];
            planes[c][cell] = header_.single_precision
                                  ? static_cast<double>(lines_.number<float>(field))
                                  : lines_.number<double>(field);
        }
        advance();
    }

    /// To the next cell in row-major order.
    void advance()
    {
        for (std::size_t a = index_.size(); a-- > 0;) {
            if (++index_[a] < header_.axes[a].values.size()) return;
            index_[a] = 0;
        }
    }

    std::filesystem::path path_;
    std::ifstream stream_;
    CsvLines lines_;
    TableHeader header_;
    std::vector<std::size_t> index_;  // of the next cell on each axis
    std::size_t rows_left_ = 0;
};

}  // namespace

std::unique_ptr<TableReader> open_csv(const std::filesystem::path& path)
{
    return std::make_unique<CsvReader>(path);
}

}  // namespace gonio

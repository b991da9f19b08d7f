// SPDX-License-Identifier: Apache-2.0
// Writes a table as CSV: comment lines with the header, names, units, then one line per cell.
//     # gonio table 1
//     # quantity: "brdf"
//     # axis: {"name":"theta_i","unit":"deg","samples":"centre","values":[0.5,1.5, ...]}
//     # attribute: {"alpha":0.1}
//     theta_i,delta_phi,R
//     degree,degree,1/sr
//     0.5,0.5,0.318
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/atomic_file.hpp"
#include "output/csv_format.hpp"
#include "output/formats.hpp"
#include "output/rows.hpp"
#include "output/table_json.hpp"

namespace gonio {
namespace {

std::string comments(const TableHeader& header)
{
    auto json = to_json(header);
    std::string text = fmt::format("{}\n", csv_first_line);
    const auto add = [&](const std::string& key, const nlohmann::ordered_json& value) {
        text += fmt::format("# {}: {}\n", key, text_of(value));
    };
    for (const auto* key : {"quantity", "unit", "precision", "sweep_axes", "channels"}) {
        add(key, json.at(key));
    }
    for (const auto& axis : json.at("axes")) add("axis", axis);
    for (const auto& [name, value] : json.at("attributes").items()) {
        add("attribute", {{name, value}});
    }
    return text;
}

class CsvFormat {
public:
    CsvFormat(const TableHeader& header, const std::filesystem::path& path)
        : header_(header), file_(path)
    {
        for (const auto& axis : header.axes) {
            auto& texts = axis_texts_.emplace_back();
            for (const auto value : axis.values) texts.push_back(fmt::format("{},", value));
        }
        file_.write(fmt::format("{}{}\n{}\n", comments(header), fmt::join(csv_names(header), ","),
                                fmt::join(csv_units(header), ",")));
    }

    template <class Real>
    void put(const Rows<Real>& rows)
    {
        for (std::size_t row = 0; row < rows.count; ++row) {
            const auto start = outer_coordinates(rows.first + row);
            for (std::size_t k = 0; k < header_.row_length(); ++k) {
                text_.append(start);
                if (!axis_texts_.empty()) text_.append(axis_texts_.back()[k]);
                append_values(rows, row * header_.row_length() + k);
            }
            file_.write(text_.data(), text_.size());
            text_.clear();
        }
    }

    void finish() { file_.commit(); }

private:
    std::string outer_coordinates(std::size_t row) const
    {
        std::string text;
        for (std::size_t a = header_.axes.size(); a-- > 1;) {
            const auto& texts = axis_texts_[a - 1];
            text.insert(0, texts[row % texts.size()]);
            row /= texts.size();
        }
        return text;
    }

    /// The shortest decimals that read back as the same float or double.
    template <class Real>
    void append_values(const Rows<Real>& rows, std::size_t cell)
    {
        for (std::size_t c = 0; c < rows.planes.size(); ++c) {
            const auto value = rows.planes[c][cell];
            const auto out = std::back_inserter(text_);
            if (header_.single_precision) {
                fmt::format_to(out, "{}", static_cast<float>(value));
            } else {
                fmt::format_to(out, "{}", static_cast<double>(value));
            }
            text_.push_back(c + 1 < rows.planes.size() ? ',' : '\n');
        }
    }

    TableHeader header_;
    AtomicFile file_;
    std::vector<std::vector<std::string>> axis_texts_;
    fmt::memory_buffer text_;
};

}  // namespace

std::vector<std::string> csv_names(const TableHeader& header)
{
    std::vector<std::string> names;
    for (const auto& axis : header.axes) names.push_back(axis.name);
    names.insert(names.end(), header.channels.begin(), header.channels.end());
    return names;
}

std::vector<std::string> csv_units(const TableHeader& header)
{
    std::vector<std::string> units;
    for (const auto& axis : header.axes) units.push_back(axis.unit);
    units.insert(units.end(), header.channels.size(), header.unit);
    return units;
}

std::unique_ptr<TableWriter> make_csv_writer(const std::filesystem::path& path,
                                             const TableHeader& header)
{
    return std::make_unique<OrderedWriter<CsvFormat>>(header, path);
}

}  // namespace gonio

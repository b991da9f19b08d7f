// SPDX-License-Identifier: Apache-2.0
// Gathers and words what `gonio info` says about a file.
#include "output/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/check.hpp"
#include "output/conventions.hpp"
#include "output/formats.hpp"
#include "output/table_json.hpp"

namespace gonio {
namespace {

class Gatherer {
public:
    void add(const std::vector<double>& values, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k) {
            const double value = values[k];
            if (!std::isfinite(value)) {
                ++range_.not_finite;
                continue;
            }
            range_.min = std::fmin(range_.min, value);
            range_.max = std::fmax(range_.max, value);
            sum_ += value;
            ++finite_;
        }
    }

    ChannelRange range() const
    {
        auto range = range_;
        range.mean = sum_ / static_cast<double>(finite_);
        return range;
    }

private:
    ChannelRange range_;
    double sum_ = 0;
    std::size_t finite_ = 0;
};

std::string line(const std::string& key, const std::string& value)
{
    return fmt::format("{:<14} {}\n", key, value);
}

std::string range_text(const ChannelRange& range)
{
    auto text =
        fmt::format("min {:.6g}, max {:.6g}, mean {:.6g}", range.min, range.max, range.mean);
    if (range.not_finite > 0) text += fmt::format(", {} not finite", range.not_finite);
    return text;
}

}  // namespace

Description describe(const std::filesystem::path& path)
{
    const auto reader = open_table(path);
    const auto& header = reader->header();
    const auto rows = header.rows();
    const auto block = std::min(rows, block_rows(header));
    std::vector<std::vector<double>> values(header.channels.size(),
                                            std::vector<double>(block * header.row_length()));
    std::vector<double*> planes;
    for (auto& plane : values) planes.push_back(plane.data());
    std::vector<Gatherer> gatherers(planes.size());
    for (std::size_t row = 0; row < rows; row += block) {
        const auto count = std::min(block, rows - row);
        reader->read(count, planes);
        for (std::size_t c = 0; c < planes.size(); ++c) {
            gatherers[c].add(values[c], count * header.row_length());
        }
    }
    Description description{format_of(path), header, {}};
    for (const auto& gatherer : gatherers) description.ranges.push_back(gatherer.range());
    return description;
}

std::string text_of(const Description& description)
{
    const auto& header = description.header;
    std::string text = line("format", description.format);
    text += line("quantity", fmt::format("{} [{}]", header.quantity, header.unit));
    text += line("values", fmt::format("{} cells of {}", shape_text(header),
                                       header.single_precision ? "float32" : "float64"));
    for (std::size_t a = 0; a < header.axes.size(); ++a) {
        const auto kind = a < header.sweep_axes ? "swept" : "axis";
        const auto& axis = header.axes[a];
        text += line(fmt::format("{} {}", kind, axis.name), axis_text(axis));
    }
    text += line("rows", rows_text(header));
    text += line("columns", columns_text(header));
    text += line("texels", texels_text(header));
    for (std::size_t c = 0; c < description.ranges.size(); ++c) {
        text += line("channel " + header.channels[c], range_text(description.ranges[c]));
    }
    for (const auto& [name, attribute] : header.attributes) {
        const auto* words = std::get_if<std::string>(&attribute);
        text += line(name, words ? *words : text_of(to_json(attribute)));
    }
    return text;
}

nlohmann::ordered_json to_json(const Description& description)
{
    auto ranges = nlohmann::ordered_json::object();
    for (std::size_t c = 0; c < description.ranges.size(); ++c) {
        const auto& range = description.ranges[c];
        ranges[description.header.channels[c]] = {{"min", range.min},
                                                  {"max", range.max},
                                                  {"mean", range.mean},
                                                  {"not_finite", range.not_finite}};
    }
    return {
        {"format", description.format}, {"table", to_json(description.header)}, {"ranges", ranges}};
}

}  // namespace gonio

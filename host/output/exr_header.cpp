// SPDX-License-Identifier: Apache-2.0
// Fills OpenEXR headers from a table's header.
#include "output/exr_header.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <map>

#include "gonio/errors.hpp"
#include "output/check.hpp"
#include "output/conventions.hpp"
#include "output/table_json.hpp"

namespace gonio {
namespace {

Imf::Compression compression_from(const std::string& name)
{
    static const std::map<std::string, Imf::Compression> known = {{"none", Imf::NO_COMPRESSION},
                                                                  {"rle", Imf::RLE_COMPRESSION},
                                                                  {"zips", Imf::ZIPS_COMPRESSION},
                                                                  {"zip", Imf::ZIP_COMPRESSION},
                                                                  {"piz", Imf::PIZ_COMPRESSION}};
    const auto found = known.find(name);
    if (found == known.end()) {
        throw UsageError(fmt::format("compression is none, rle, zips, zip or piz, not '{}'", name));
    }
    return found->second;
}

/// OpenEXR's pixel coordinates are int, and it refuses windows beyond half of its range.
int pixels(std::size_t count, const TableHeader& header)
{
    if (count > std::numeric_limits<int>::max() / 2) {
        throw UsageError(fmt::format(
            "an EXR image of {} cells would have {} rows or columns, more than EXR can hold: write "
            "npy",
            shape_text(header), count));
    }
    return static_cast<int>(count);
}

void insert(Imf::Header& part, const std::string& name, const std::string& text)
{
    part.insert(name, Imf::StringAttribute(text));
}

void insert(Imf::Header& part, const std::string& name, double number)
{
    part.insert(name, Imf::DoubleAttribute(number));
}

void insert(Imf::Header& part, const std::string& name, const std::vector<double>& numbers)
{
    insert(part, name, fmt::format("{}", fmt::join(numbers, " ")));
}

/// The values of the swept axes in part `part`, the first axis slowest.
void insert_sweep(Imf::Header& image, const TableHeader& header, std::size_t part)
{
    std::string name;
    std::size_t rest = part;
    for (std::size_t a = header.sweep_axes; a-- > 0;) {
        const auto& axis = header.axes[a];
        const double value = axis.values[rest % axis.values.size()];
        rest /= axis.values.size();
        insert(image, "sweep." + axis.name, value);
        name = fmt::format("{}={}{}{}", axis.name, value, name.empty() ? "" : " ", name);
    }
    if (!name.empty()) image.setName(name);
}

Imf::Header common_header(const TableHeader& header, const WriteOptions& options)
{
    const auto width = pixels(header.row_length(), header);
    const auto height = pixels(header.rows() / exr_parts(header), header);
    Imf::Header image(width, height);
    image.setType(Imf::SCANLINEIMAGE);
    image.compression() = compression_from(options.compression);
    for (std::size_t c = 0; c < header.channels.size(); ++c) {
        image.channels().insert(exr_channel_name(header, c),
                                Imf::Channel(options.half ? Imf::HALF : Imf::FLOAT));
    }
    insert(image, exr_table_attribute, text_of(to_json(header)));
    insert(image, "quantity", header.quantity);
    insert(image, "unit", header.unit);
    insert(image, "rows", rows_text(header));
    insert(image, "columns", columns_text(header));
    insert(image, "texels", texels_text(header));
    for (const auto& axis : header.axes) insert(image, "axis." + axis.name, axis_text(axis));
    for (const auto& [name, attribute] : header.attributes) {
        std::visit(
            [&, &key = name](const auto& value) { insert(image, "attribute." + key, value); },
            attribute);
    }
    return image;
}

}  // namespace

std::size_t exr_parts(const TableHeader& header)
{
    std::size_t parts = 1;
    for (std::size_t a = 0; a < header.sweep_axes; ++a) parts *= header.axes[a].values.size();
    return parts;
}

std::string exr_channel_name(const TableHeader& header, std::size_t channel)
{
    return header.quantity + "." + header.channels[channel];
}

std::vector<Imf::Header> exr_headers(const TableHeader& header, const WriteOptions& options)
{
    std::vector<Imf::Header> parts(exr_parts(header), common_header(header, options));
    for (std::size_t p = 0; p < parts.size(); ++p) insert_sweep(parts[p], header, p);
    return parts;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Reads the tables that exr_writer.cpp wrote, any number of rows at a time.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <optional>

#include "gonio/errors.hpp"
#include "output/exr_header.hpp"
#include "output/formats.hpp"
#include "output/table_json.hpp"

namespace gonio {
namespace {

class ExrReader final : public TableReader {
public:
    explicit ExrReader(const std::filesystem::path& path) : path_(path)
    {
        translate([&] { image_.emplace(path_.c_str()); });
        const auto* json =
            image_->header(0).findTypedAttribute<Imf::StringAttribute>(exr_table_attribute);
        if (!json) {
            throw UsageError(
                fmt::format("{}: an EXR file that gonio did not write: it has no "
                            "attribute {}",
                            path_.string(), exr_table_attribute));
        }
        header_ = header_from_json(parse_json(json->value(), path_.string()), path_.string());
        header_.single_precision = true;
        part_rows_ = header_.rows() / exr_parts(header_);
        check_parts();
    }

    const TableHeader& header() const override { return header_; }

    void read(std::size_t count, const std::vector<double*>& planes) override
    {
        for (std::size_t done = 0; done < count;) {
            const auto part_row = next_ % part_rows_;
            const auto lines = std::min(count - done, part_rows_ - part_row);
            translate([&] { read_lines(planes, done, next_ / part_rows_, part_row, lines); });
            done += lines;
            next_ += lines;
        }
    }

private:
    template <class Action>
    void translate(Action action)
    {
        try {
            action();
        } catch (const std::exception& fault) {
            throw RunError(fmt::format("{}: {}", path_.string(), fault.what()));
        }
    }

    void check_parts()
    {
        bool fits = static_cast<std::size_t>(image_->parts()) == exr_parts(header_);
        for (int p = 0; fits && p < image_->parts(); ++p) {
            const auto& part = image_->header(p);
            const auto& window = part.dataWindow();
            fits = window.min == Imath::V2i(0, 0) &&
                   static_cast<std::size_t>(window.max.x) + 1 == header_.row_length() &&
                   static_cast<std::size_t>(window.max.y) + 1 == part_rows_;
            for (std::size_t c = 0; c < header_.channels.size(); ++c) {
                fits = fits && part.channels().findChannel(exr_channel_name(header_, c));
            }
        }
        if (!fits) {
            throw RunError(fmt::format("{}: its images are not those that its attribute {} says",
                                       path_.string(), exr_table_attribute));
        }
    }

    void read_lines(const std::vector<double*>& planes, std::size_t done, std::size_t part,
                    std::size_t first, std::size_t count)
    {
        const auto width = header_.row_length();
        std::vector<std::vector<float>> pixels(planes.size(), std::vector<float>(count * width));
        Imf::InputPart image(*image_, static_cast<int>(part));
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < planes.size(); ++c) {
            frame.insert(exr_channel_name(header_, c),
                         Imf::Slice::Make(Imf::FLOAT, pixels[c].data(),
                                          Imath::V2i(0, static_cast<int>(first)),
                                          static_cast<int64_t>(width), static_cast<int64_t>(count),
                                          sizeof(float), width * sizeof(float)));
        }
        image.setFrameBuffer(frame);
        image.readPixels(static_cast<int>(first), static_cast<int>(first + count - 1));
        for (std::size_t c = 0; c < planes.size(); ++c) {
            std::copy(pixels[c].begin(), pixels[c].end(), planes[c] + done * width);
        }
    }

    std::filesystem::path path_;
    std::optional<Imf::MultiPartInputFile> image_;
    TableHeader header_;
    std::size_t part_rows_ = 0;
    std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<TableReader> open_exr(const std::filesystem::path& path)
{
    return std::make_unique<ExrReader>(path);
}

}  // namespace gonio

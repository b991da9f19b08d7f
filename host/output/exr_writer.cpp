// SPDX-License-Identifier: Apache-2.0
// Streams a table into an OpenEXR file; OpenEXR's own threads compress.
#include <Iex.h>
#include <Imath/half.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <thread>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/exr_header.hpp"
#include "output/formats.hpp"
#include "output/rows.hpp"

namespace gonio {
namespace {

// What OpenEXR may hold of uncompressed pixels; it keeps the buffers of every part to the end.
constexpr std::size_t buffer_limit = std::size_t{256} << 20;

class AtomicStream final : public Imf::OStream {
public:
    explicit AtomicStream(AtomicFile& file)
        : Imf::OStream(file.path().string().c_str()), file_(file)
    {
    }
    void write(const char bytes[], int count) override
    {
        file_.write(bytes, static_cast<std::size_t>(count));
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t offset) override { file_.seek(offset); }

private:
    AtomicFile& file_;
};

std::size_t lines_in_buffer(const std::string& compression)
{
    if (compression == "zip") return 16;
    if (compression == "piz") return 32;
    return 1;
}

/// As many of OpenEXR's threads as fit the limit: a part has two line buffers a thread.
int thread_count(const TableHeader& header, const WriteOptions& options)
{
    const auto all = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (Imf::globalThreadCount() < all) Imf::setGlobalThreadCount(all);
    const auto value_size = options.half ? sizeof(half) : sizeof(float);
    const auto one_each = header.row_length() * header.channels.size() * value_size *
                          lines_in_buffer(options.compression) * exr_parts(header);
    for (int threads = all; threads > 0; --threads) {
        if (2 * static_cast<std::size_t>(threads) * one_each <= buffer_limit) return threads;
    }
    if (one_each <= buffer_limit) return 0;
    throw UsageError(fmt::format(
        "an EXR file of {} parts with rows of {} values needs {} MiB of buffers, more than {}: "
        "use compression zips, npy, or a file for each swept value",
        exr_parts(header), header.row_length(), one_each >> 20, buffer_limit >> 20));
}

class ExrFormat {
public:
    ExrFormat(const TableHeader& header, const std::filesystem::path& path,
              const WriteOptions& options)
        : header_(header),
          half_(options.half),
          part_rows_(header.rows() / exr_parts(header)),
          file_(path),
          stream_(file_)
    {
        const auto threads = thread_count(header, options);
        const auto parts = exr_headers(header, options);
        translate([&] {
            image_.emplace(stream_, parts.data(), static_cast<int>(parts.size()), false, threads);
        });
    }

    template <class Real>
    void put(const Rows<Real>& rows)
    {
        const auto store = [this](const auto& part) { this->write_parts(part); };
        if (half_) {
            check_range(rows);
            convert_rows<float>(rows, header_.row_length(), [&](const Rows<float>& floats) {
                convert_rows<half>(floats, header_.row_length(), store);
            });
        } else {
            convert_rows<float>(rows, header_.row_length(), store);
        }
    }

    void finish()
    {
        image_.reset();  // writes the line offsets; what it swallows, commit() reports
        file_.commit();
    }

private:
    /// OpenEXR's exceptions are its own.
    template <class Action>
    void translate(Action action)
    {
        try {
            action();
        } catch (const Iex::BaseExc& fault) {
            throw RunError(fmt::format("{}: {}", file_.path().string(), fault.what()));
        }
    }

    /// Splits the rows where a part ends.
    template <class Pixel>
    void write_parts(const Rows<Pixel>& rows)
    {
        for (std::size_t done = 0; done < rows.count;) {
            const auto row = rows.first + done;
            const auto count = std::min(rows.count - done, part_rows_ - row % part_rows_);
            translate([&] { write_lines(rows, done, row / part_rows_, count); });
            done += count;
        }
    }

    template <class Pixel>
    void write_lines(const Rows<Pixel>& rows, std::size_t done, std::size_t part, std::size_t count)
    {
        Imf::OutputPart image(*image_, static_cast<int>(part));
        const auto row_size = header_.row_length() * sizeof(Pixel);
        const auto origin = Imath::V2i(0, image.currentScanLine());
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < rows.planes.size(); ++c) {
            const void* first = rows.planes[c] + done * header_.row_length();
            frame.insert(exr_channel_name(header_, c),
                         Imf::Slice::Make(pixel_type<Pixel>(), first, origin,
                                          static_cast<int64_t>(header_.row_length()),
                                          static_cast<int64_t>(count), sizeof(Pixel), row_size));
        }
        image.setFrameBuffer(frame);
        image.writePixels(static_cast<int>(count));
    }

    template <class Pixel>
    static constexpr Imf::PixelType pixel_type()
    {
        return std::is_same_v<Pixel, half> ? Imf::HALF : Imf::FLOAT;
    }

    /// A lobe's peak can be too high for a half, which would silently become infinite.
    template <class Real>
    void check_range(const Rows<Real>& rows) const
    {
        for (std::size_t c = 0; c < rows.planes.size(); ++c) {
            for (std::size_t k = 0; k < rows.count * header_.row_length(); ++k) {
                const auto value = static_cast<double>(rows.planes[c][k]);
                if (std::isfinite(value) && std::abs(value) > HALF_MAX) {
                    throw RunError(
                        fmt::format("{}: {} in row {} is beyond the largest half, {}: write float",
                                    file_.path().string(), value,
                                    rows.first + k / header_.row_length(), HALF_MAX));
                }
            }
        }
    }

    TableHeader header_;
    bool half_;
    std::size_t part_rows_;
    AtomicFile file_;
    AtomicStream stream_;
    std::optional<Imf::MultiPartOutputFile> image_;
};

}  // namespace

std::unique_ptr<TableWriter> make_exr_writer(const std::filesystem::path& path,
                                             const TableHeader& header, const WriteOptions& options)
{
    return std::make_unique<OrderedWriter<ExrFormat>>(header, path, options);
}

}  // namespace gonio

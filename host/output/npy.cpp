// SPDX-License-Identifier: Apache-2.0
// NumPy's .npy, format 1.0: shape (channel, axis 0, axis 1, ...), the first left out if it is one.
// The layout is that of numpy/lib/format.py; the header is in the sidecar.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "gonio/errors.hpp"
#include "output/formats.hpp"
#include "output/plane_file.hpp"
#include "output/rows.hpp"
#include "output/sidecar.hpp"

namespace gonio {
namespace {

constexpr std::string_view magic("\x93NUMPY\x01\x00", 8);
constexpr std::size_t alignment = 64;

/// Everything in front of the values, padded as numpy.save pads it.
std::string preamble(const TableHeader& header)
{
    std::vector<std::size_t> shape;
    if (header.channels.size() > 1) shape.push_back(header.channels.size());
    for (const auto& axis : header.axes) shape.push_back(axis.values.size());
    std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}",
                                   header.single_precision ? "<f4" : "<f8", fmt::join(shape, ", "),
                                   shape.size() == 1 ? "," : "");
    const auto unpadded = magic.size() + 2 + text.size() + 1;
    text.append((alignment - unpadded % alignment) % alignment, ' ');
    text += '\n';
    std::string bytes(magic);
    bytes += static_cast<char>(text.size() & 0xff);
    bytes += static_cast<char>(text.size() >> 8);
    return bytes + text;
}

PlaneLayout layout_of(const TableHeader& header)
{
    return {preamble(header).size(), header.single_precision ? sizeof(float) : sizeof(double),
            header.row_length(), header.rows(), header.channels.size()};
}

class NpyFormat {
public:
    NpyFormat(const TableHeader& header, const std::filesystem::path& path)
        : header_(header), layout_(layout_of(header)), file_(path)
    {
        file_.write(preamble(header));
    }

    template <class Real>
    void put(const Rows<Real>& rows)
    {
        const auto store = [this](const auto& part) {
            for (std::size_t c = 0; c < part.planes.size(); ++c) {
                write_plane_rows(file_, layout_, c, part.first, part.count, part.planes[c]);
            }
        };
        if (header_.single_precision) {
            convert_rows<float>(rows, header_.row_length(), store);
        } else {
            convert_rows<double>(rows, header_.row_length(), store);
        }
    }

    void finish()
    {
        write_sidecar(file_.path(), header_);
        file_.commit();
    }

private:
    TableHeader header_;
    PlaneLayout layout_;
    AtomicFile file_;
};

/// The header from the sidecar, with the precision that the file itself has.
TableHeader header_of(const std::filesystem::path& path)
{
    const auto sidecar = sidecar_path(path).string();
    auto header = read_sidecar(path);
    if (!header) {
        throw RunError(
            fmt::format("{}: its axes are unknown without {}, which is missing or not "
                        "gonio's",
                        path.string(), sidecar));
    }
    for (const bool single_precision : {true, false}) {
        header->single_precision = single_precision;
        auto start = preamble(*header);
        const auto expected = start;
        std::ifstream(path, std::ios::binary)
            .read(start.data(), static_cast<std::streamsize>(start.size()));
        if (start == expected) return *header;
    }
    throw RunError(fmt::format("{}: is not the array that {} describes", path.string(), sidecar));
}

class NpyReader final : public TableReader {
public:
    explicit NpyReader(const std::filesystem::path& path)
        : header_(header_of(path)), planes_(path, layout_of(header_))
    {
    }

    const TableHeader& header() const override { return header_; }

    void read(std::size_t count, const std::vector<double*>& planes) override
    {
        for (std::size_t c = 0; c < planes.size(); ++c) planes_.read(c, next_, count, planes[c]);
        next_ += count;
    }

private:
    TableHeader header_;
    PlaneReader planes_;
    std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<TableWriter> make_npy_writer(const std::filesystem::path& path,
                                             const TableHeader& header)
{
    return std::make_unique<OrderedWriter<NpyFormat>>(header, path);
}

std::unique_ptr<TableReader> open_npy(const std::filesystem::path& path)
{
    return std::make_unique<NpyReader>(path);
}

}  // namespace gonio

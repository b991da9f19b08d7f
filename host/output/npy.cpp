// SPDX-License-Identifier: Apache-2.0
// NumPy's .npy, format 1.0: shape (channel, axis 0, axis 1, ...), the first left out if it is one.
// The layout is that of numpy/lib/format.py; the header is in the sidecar.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <fstream>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/formats.hpp"
#include "output/rows.hpp"
#include "output/sidecar.hpp"

static_assert(std::endian::native == std::endian::little, "the formats store the host's bytes");

namespace gonio
{
namespace
{

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
    const auto length = static_cast<std::uint16_t>(text.size());
    std::string bytes(magic);
    bytes += static_cast<char>(length & 0xff);
    bytes += static_cast<char>(length >> 8);
    return bytes + text;
}

/// Where a row's values are: byte offsets in a file that holds one channel after the other.
struct Layout {
    explicit Layout(const TableHeader& header)
        : start(preamble(header).size()),
          value_size(header.single_precision ? sizeof(float) : sizeof(double)),
          row_size(header.row_length() * value_size),
          plane_size(header.rows() * row_size),
          file_size(start + plane_size * header.channels.size())
    {
    }

    std::uint64_t offset(std::size_t channel, std::size_t row) const
    {
        return start + channel * plane_size + row * row_size;
    }

    std::uint64_t start, value_size, row_size, plane_size, file_size;
};

class NpyFormat
{
public:
    NpyFormat(const TableHeader& header, const std::filesystem::path& path)
        : header_(header), layout_(header), file_(path)
    {
        file_.write(preamble(header));
    }

    template <class Real>
    void put(const Rows<Real>& rows)
    {
        const auto store = [this](const auto& part) { this->write_planes(part); };
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
    template <class Real>
    void write_planes(const Rows<Real>& rows)
    {
        for (std::size_t c = 0; c < rows.planes.size(); ++c) {
            file_.seek(layout_.offset(c, rows.first));
            file_.write(rows.planes[c], rows.count * layout_.row_size);
        }
    }

    TableHeader header_;
    Layout layout_;
    AtomicFile file_;
};

std::string first_bytes(std::ifstream& file, std::size_t count)
{
    std::string bytes(count, '\0');
    file.seekg(0);
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    return bytes;
}

class NpyReader final : public TableReader
{
public:
    explicit NpyReader(const std::filesystem::path& path)
        : path_(path), file_(path, std::ios::binary), header_(header_beside(path))
    {
        const bool single = holds(true);
        if (!single && !holds(false)) {
            throw RunError(fmt::format("{}: is not the array that {} describes", path.string(),
                                       sidecar_path(path).string()));
        }
        header_.single_precision = single;
        layout_ = Layout(header_);
        const auto size = std::filesystem::file_size(path);
        if (size != layout_.file_size) {
            throw RunError(fmt::format("{}: has {} bytes, and its header says {}", path.string(),
                                       size, layout_.file_size));
        }
    }

    const TableHeader& header() const override { return header_; }

    void read(std::size_t count, const std::vector<double*>& planes) override
    {
        for (std::size_t c = 0; c < planes.size(); ++c) {
            file_.seekg(static_cast<std::streamoff>(layout_.offset(c, next_)));
            const auto values = count * header_.row_length();
            header_.single_precision ? read_plane<float>(values, planes[c])
                                     : read_plane<double>(values, planes[c]);
        }
        next_ += count;
    }

private:
    static TableHeader header_beside(const std::filesystem::path& path)
    {
        auto header = read_sidecar(path);
        if (!header) {
            throw RunError(
                fmt::format("{}: its axes are unknown without {}, which is missing or not gonio's",
                            path.string(), sidecar_path(path).string()));
        }
        return *header;
    }

    bool holds(bool single_precision)
    {
        header_.single_precision = single_precision;
        const auto expected = preamble(header_);
        return first_bytes(file_, expected.size()) == expected;
    }

    template <class Real>
    void read_plane(std::size_t values, double* plane)
    {
        std::vector<Real> stored(values);
        file_.read(reinterpret_cast<char*>(stored.data()),
                   static_cast<std::streamsize>(values * sizeof(Real)));
        if (!file_) throw RunError(fmt::format("{}: cannot be read", path_.string()));
        std::copy(stored.begin(), stored.end(), plane);
    }

    std::filesystem::path path_;
    std::ifstream file_;
    TableHeader header_;
    Layout layout_{header_};
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

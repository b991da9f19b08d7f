// SPDX-License-Identifier: Apache-2.0
// Files that hold one channel after the other behind a preamble: .npy and MERL's .binary.
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "gonio/table.hpp"
#include "output/atomic_file.hpp"

namespace gonio {

static_assert(std::endian::native == std::endian::little, "the formats store the host's bytes");

struct PlaneLayout {
    std::uint64_t preamble;    ///< bytes in front of the first plane
    std::uint64_t value_size;  ///< bytes
    std::uint64_t row_length;  ///< values
    std::uint64_t rows;
    std::uint64_t planes;

    std::uint64_t offset(std::uint64_t plane, std::uint64_t row) const
    {
        return preamble + (plane * rows + row) * row_length * value_size;
    }
};

/// Writes `count` rows of a plane, beginning with row `first`.
template <class Stored>
void write_plane_rows(AtomicFile& file, const PlaneLayout& layout, std::size_t plane,
                      std::size_t first, std::size_t count, const Stored* values)
{
    file.seek(layout.offset(plane, first));
    file.write(values, count * layout.row_length * sizeof(Stored));
}

class PlaneReader {
public:
    /// Throws RunError if the file's size is not what the layout needs.
    PlaneReader(const std::filesystem::path& path, const PlaneLayout& layout);

    /// Reads rows that are stored as float (value_size 4) or double (8).
    void read(std::size_t plane, std::size_t first, std::size_t count, double* values);

private:
    template <class Stored>
    void read_as(std::size_t count, double* values);

    std::filesystem::path path_;
    std::ifstream file_;
    PlaneLayout layout_;
};

}  // namespace gonio

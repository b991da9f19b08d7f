// SPDX-License-Identifier: Apache-2.0
// Reads rows of a file that holds one channel after the other.
#include "output/plane_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gonio/errors.hpp"

namespace gonio {

PlaneReader::PlaneReader(const std::filesystem::path& path, const PlaneLayout& layout)
    : path_(path), file_(path, std::ios::binary), layout_(layout)
{
    const auto size = std::filesystem::file_size(path);
    const auto expected = layout.offset(layout.planes, 0);
    if (size != expected) {
        throw RunError(
            fmt::format("{}: has {} bytes, and its header says {}", path.string(), size, expected));
    }
}

void PlaneReader::read(std::size_t plane, std::size_t first, std::size_t count, double* values)
{
    file_.seekg(static_cast<std::streamoff>(layout_.offset(plane, first)));
    layout_.value_size == sizeof(float) ? read_as<float>(count, values)
                                        : read_as<double>(count, values);
}

template <class Stored>
void PlaneReader::read_as(std::size_t count, double* values)
{
    std::vector<Stored> stored(count * layout_.row_length);
    file_.read(reinterpret_cast<char*>(stored.data()),
               static_cast<std::streamsize>(stored.size() * sizeof(Stored)));
    if (!file_) throw RunError(fmt::format("{}: cannot be read", path_.string()));
    std::copy(stored.begin(), stored.end(), values);
}

}  // namespace gonio

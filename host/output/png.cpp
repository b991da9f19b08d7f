// SPDX-License-Identifier: Apache-2.0
// Writes contact sheets with libpng's simplified interface, which needs no longjmp.
#include "output/png.hpp"

#include <fmt/format.h>
#include <png.h>

#include <vector>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"

namespace gonio {

void write_png(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
               std::span<const std::uint8_t> rgb)
{
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = PNG_FORMAT_RGB;
    if (rgb.size() != PNG_IMAGE_SIZE(image)) {
        throw RunError(fmt::format("{}: an image of {} x {} pixels was given {} bytes",
                                   path.string(), width, height, rgb.size()));
    }
    std::vector<char> bytes(PNG_IMAGE_PNG_SIZE_MAX(image));
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr)) {
        throw RunError(fmt::format("{}: {}", path.string(), image.message));
    }
    write_file(path, {bytes.data(), size});
}

}  // namespace gonio

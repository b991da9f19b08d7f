// SPDX-License-Identifier: Apache-2.0
// Reads surfaces and PNG files with cairo.
#include "output/picture_fixtures.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace gonio::test {

Pixel Picture::at(int x, int y) const
{
    return pixels.at(static_cast<std::size_t>(y * width + x));
}

Picture read_picture(cairo_surface_t* surface)
{
    cairo_surface_flush(surface);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("no picture");
    Picture picture{
        cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
    const bool opaque = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_RGB24;
    const unsigned char* row = cairo_image_surface_get_data(surface);
    for (int y = 0; y < picture.height; ++y, row += cairo_image_surface_get_stride(surface))
        for (int x = 0; x < picture.width; ++x) {
            std::uint32_t argb = 0;
            std::memcpy(&argb, row + 4L * x, sizeof argb);
            const auto byte = [argb](int shift) { return static_cast<int>(argb >> shift & 255); };
            picture.pixels.push_back({byte(16), byte(8), byte(0), opaque ? 255 : byte(24)});
        }
    return picture;
}

Picture read_picture(const std::filesystem::path& png)
{
    return read_picture(Surface(cairo_image_surface_create_from_png(png.c_str())).get());
}

Extent extent_of(const Picture& picture, const std::function<bool(int x, int y)>& belongs)
{
    Extent extent{picture.width, picture.height, -1, -1, 0};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (belongs(x, y))
                extent = {std::min(extent.left, x), std::min(extent.top, y),
                          std::max(extent.right, x), std::max(extent.bottom, y), extent.count + 1};
    return extent;
}

Extent difference(const Picture& a, const Picture& b)
{
    return extent_of(a, [&](int x, int y) { return a.at(x, y) != b.at(x, y); });
}

}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// Pictures as the tests look at them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "output/canvas.hpp"

namespace gonio::test {

/// Colours premultiplied with alpha, 0 to 255.
struct Pixel {
    int red = 0, green = 0, blue = 0, alpha = 255;
    bool operator==(const Pixel&) const = default;
};

/// x to the right, y down, in pixels.
struct Picture {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;

    Pixel at(int x, int y) const;
};

Picture read_picture(cairo_surface_t* surface);
Picture read_picture(const std::filesystem::path& png);

/// The smallest range of pixels that holds all of some kind; first > last if there is none.
struct Extent {
    int left, top, right, bottom, count;
    int width() const { return right - left + 1; }
    int height() const { return bottom - top + 1; }
};

Extent extent_of(const Picture& picture, const std::function<bool(int x, int y)>& belongs);

/// Where two pictures of the same size differ.
Extent difference(const Picture& a, const Picture& b);

}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// Pictures as files: what was computed, and what a screen shows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "gonio/errors.hpp"
#include "gonio/picture.hpp"
#include "output/canvas.hpp"
#include "output/png.hpp"
#include "output/tone.hpp"

namespace gonio {
namespace {

/// Rows from the top; red, green and blue of each pixel.
std::vector<std::uint8_t> screen_bytes(const Table& picture, const std::optional<double>& exposure)
{
    std::vector<std::vector<float>> planes;
    for (const auto& plane : picture.values) planes.emplace_back(plane.begin(), plane.end());
    const std::vector<glm::vec3> radiance = as_rgb(planes);
    const float factor = exposure ? static_cast<float>(*exposure) : exposure_of(radiance);
    std::vector<std::uint8_t> bytes;
    for (const glm::vec3 value : radiance) {
        const glm::vec3 shown = to_screen(factor * value);
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * shown[c])));
    }
    return bytes;
}

void draw(cairo_t* cairo, const PictureCard& card, int left, int top)
{
    const TableHeader& header = card.picture.header;
    const Surface image = make_image(CAIRO_FORMAT_RGB24, static_cast<int>(header.row_length()),
                                     static_cast<int>(header.rows()));
    const std::vector<std::uint8_t> bytes = screen_bytes(card.picture, card.exposure);
    unsigned char* data = cairo_image_surface_get_data(image.get());
    const int stride = cairo_image_surface_get_stride(image.get());
    for (std::size_t k = 0; k < header.cells(); ++k) {
        const std::uint32_t pixel = std::uint32_t{bytes[3 * k]} << 16 |
                                    std::uint32_t{bytes[3 * k + 1]} << 8 | bytes[3 * k + 2];
        unsigned char* row = data + static_cast<std::ptrdiff_t>(k / header.row_length()) * stride;
        std::memcpy(row + k % header.row_length() * sizeof pixel, &pixel, sizeof pixel);
    }
    cairo_surface_mark_dirty(image.get());
    cairo_set_source_surface(cairo, image.get(), left, top);
    cairo_paint(cairo);
}

}  // namespace

void check_picture_name(const std::filesystem::path& path)
{
    if (path.extension() != ".exr" && path.extension() != ".png")
        throw UsageError(
            fmt::format("{}: the name tells the format; allowed are .exr and .png", path.string()));
}

void write_picture_sheet(const std::filesystem::path& path, const std::vector<PictureCard>& cards)
{
    int width = 0, height = 0;
    for (const PictureCard& card : cards) {
        const TableHeader& header = card.picture.header;
        width += static_cast<int>(header.row_length());
        height = std::max(height, static_cast<int>(header.rows()));
    }
    const int gap = std::max(4, height / 64), foot = std::max(16, height / 12);
    width += gap * static_cast<int>(cards.size() + 1);
    const Surface sheet = make_image(CAIRO_FORMAT_RGB24, width, height + gap + foot);
    const Context context = make_context(sheet.get());
    set_colour(context.get(), hex(0xffffff));
    cairo_paint(context.get());
    int left = gap;
    for (const PictureCard& card : cards) {
        const auto columns = static_cast<int>(card.picture.header.row_length());
        draw(context.get(), card, left, gap);
        draw_text(context.get(), {0.4 * foot, false, hex(0x202124)}, left + columns / 2.0,
                  height + gap + 0.65 * foot, card.caption, Align::centre, columns);
        left += columns + gap;
    }
    save(path, context.get());
}

void write_picture(const std::filesystem::path& path, const Table& picture,
                   const std::optional<double>& exposure)
{
    check_picture_name(path);
    if (path.extension() == ".exr") return write_table(path, "exr", picture);
    const TableHeader& header = picture.header;
    write_png(path, static_cast<std::uint32_t>(header.row_length()),
              static_cast<std::uint32_t>(header.rows()), screen_bytes(picture, exposure));
}

}  // namespace gonio

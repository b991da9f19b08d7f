// SPDX-License-Identifier: Apache-2.0
// Cairo: surfaces, text in DejaVu Sans, and the way to a PNG file.
#include "output/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <vector>

#include "gonio/errors.hpp"
#include "output/png.hpp"

namespace gonio {
namespace {

double width_of(cairo_t* cairo, const std::string& text)
{
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo, text.c_str(), &extents);
    return extents.x_advance;
}

/// Without its last character of UTF-8.
void drop_last(std::string& text)
{
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80)
        text.pop_back();
    if (!text.empty()) text.pop_back();
}

std::string shortened(cairo_t* cairo, std::string text, double width)
{
    if (width_of(cairo, text) <= width) return text;
    while (!text.empty() && width_of(cairo, text + "…") > width) drop_last(text);
    return text + "…";
}

void select(cairo_t* cairo, const Font& font)
{
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, font.size);
    set_colour(cairo, font.colour);
}

void check(cairo_status_t status, const std::string& what)
{
    if (status != CAIRO_STATUS_SUCCESS)
        throw RunError(fmt::format("{}: {}", what, cairo_status_to_string(status)));
}

}  // namespace

Surface make_image(cairo_format_t format, int width, int height)
{
    Surface surface(cairo_image_surface_create(format, width, height));
    check(cairo_surface_status(surface.get()),
          fmt::format("a picture of {} x {} pixels", width, height));
    return surface;
}

Context make_context(cairo_surface_t* surface)
{
    Context context(cairo_create(surface));
    const FontOptions options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context.get(), options.get());
    return context;
}

void set_colour(cairo_t* cairo, Colour colour, double alpha)
{
    cairo_set_source_rgba(cairo, colour.x, colour.y, colour.z, alpha);
}

void add_stop(cairo_pattern_t* gradient, double offset, Colour colour, double alpha)
{
    cairo_pattern_add_color_stop_rgba(gradient, offset, colour.x, colour.y, colour.z, alpha);
}

void rounded_box(cairo_t* cairo, const Box& box, double radius)
{
    const double quarter = std::numbers::pi / 2;
    const double left = box.x + radius, right = box.x + box.width - radius;
    const double top = box.y + radius, bottom = box.y + box.height - radius;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, right, top, radius, -quarter, 0);
    cairo_arc(cairo, right, bottom, radius, 0, quarter);
    cairo_arc(cairo, left, bottom, radius, quarter, 2 * quarter);
    cairo_arc(cairo, left, top, radius, 2 * quarter, 3 * quarter);
    cairo_close_path(cairo);
}

void draw_text(cairo_t* cairo, const Font& font, double x, double y, const std::string& text,
               Align align, double width)
{
    select(cairo, font);
    const std::string line = shortened(cairo, text, width);
    const double share = align == Align::left ? 0 : align == Align::centre ? 0.5 : 1;
    cairo_move_to(cairo, x - share * width_of(cairo, line), y);
    cairo_show_text(cairo, line.c_str());
    cairo_new_path(cairo);
}

void draw_paragraph(cairo_t* cairo, const Font& font, double x, double y, const std::string& text,
                    double width, int lines)
{
    select(cairo, font);
    std::string rest = text;
    for (; lines > 1 && !rest.empty(); --lines, y += 1.35 * font.size) {
        std::size_t end = std::min(rest.find('\n'), rest.size());
        while (width_of(cairo, rest.substr(0, end)) > width) {
            const std::size_t space = rest.rfind(' ', end - 1);
            if (space == std::string::npos) break;
            end = space;
        }
        draw_text(cairo, font, x, y, rest.substr(0, end), Align::left, width);
        rest.erase(0, end + 1);
    }
    std::ranges::replace(rest, '\n', ' ');
    draw_text(cairo, font, x, y, rest, Align::left, width);
}

void save(const std::filesystem::path& path, cairo_t* cairo)
{
    check(cairo_status(cairo), fmt::format("{}: cannot draw", path.string()));
    cairo_surface_t* image = cairo_get_target(cairo);
    cairo_surface_flush(image);
    const int width = cairo_image_surface_get_width(image);
    const int height = cairo_image_surface_get_height(image);
    const unsigned char* row = cairo_image_surface_get_data(image);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y, row += cairo_image_surface_get_stride(image)) {
        std::memcpy(pixels.data(), row, pixels.size() * sizeof pixels[0]);
        for (const std::uint32_t pixel : pixels)
            for (const int shift : {16, 8, 0})
                rgb.push_back(static_cast<std::uint8_t>(pixel >> shift & 255));
    }
    write_png(path, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), rgb);
}

}  // namespace gonio

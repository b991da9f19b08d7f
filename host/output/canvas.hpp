// SPDX-License-Identifier: Apache-2.0
// What pictures are drawn with: cairo with owners, colours, text that fits its place.
#pragma once

#include <cairo.h>

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

namespace gonio {

struct CairoDeleter {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
using Context = std::unique_ptr<cairo_t, CairoDeleter>;
using Surface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using Pattern = std::unique_ptr<cairo_pattern_t, CairoDeleter>;
using FontOptions = std::unique_ptr<cairo_font_options_t, CairoDeleter>;

/// sRGB, encoded, 0 to 1.
using Colour = glm::dvec3;

/// 0xrrggbb
constexpr Colour hex(unsigned rgb)
{
    return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}

struct Box {
    double x = 0, y = 0, width = 0, height = 0;
};

/// ARGB32 is transparent at first, RGB24 black. In pixels; throws RunError if it is larger than
/// cairo can hold (32767 a side).
Surface make_image(cairo_format_t format, int width, int height);

/// Draws on `surface` with text that does not depend on the screen's settings.
Context make_context(cairo_surface_t* surface);

void set_colour(cairo_t* cairo, Colour colour, double alpha = 1);
void add_stop(cairo_pattern_t* gradient, double offset, Colour colour, double alpha = 1);
void rounded_box(cairo_t* cairo, const Box& box, double radius);

struct Font {
    double size = 12;
    bool bold = false;
    Colour colour = {0, 0, 0};
};

enum class Align { left, centre, right };

/// One line of DejaVu Sans, its baseline at y, cut with an ellipsis to `width`.
void draw_text(cairo_t* cairo, const Font& font, double x, double y, const std::string& text,
               Align align = Align::left, double width = 1e9);

/// Lines of words, broken at spaces and line feeds; the last of at most `lines` is cut.
void draw_paragraph(cairo_t* cairo, const Font& font, double x, double y, const std::string& text,
                    double width, int lines);

/// Writes what was drawn on an RGB24 surface as PNG. Throws RunError, and leaves what was at
/// `path`, if anything drawn before or the disk failed.
void save(const std::filesystem::path& path, cairo_t* cairo);

}  // namespace gonio

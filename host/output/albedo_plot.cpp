// SPDX-License-Identifier: Apache-2.0
// Axes, grid lines and curves of the directional albedo.
#include "output/albedo_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio {
namespace {

constexpr double left = 44, right = 12, top = 30, bottom = 42, most_shown = 2;
constexpr Colour line = hex(0xb4b9be), strong = hex(0x8a9096), single = hex(0x3b5a7a);
constexpr std::array channels{hex(0xd8504a), hex(0x3a9a55), hex(0x3f82e4)};
constexpr Font label{10.5, false, hex(0x5f6368)}, heading{12, true, hex(0x202124)};

/// The place of the axes, and the way from numbers to the page.
struct Frame {
    cairo_t* cairo;
    Box box;
    double greatest;

    double x(double theta) const { return box.x + box.width * theta / 90; }
    double y(double albedo) const { return box.y + box.height * (1 - albedo / greatest); }

    void draw_line(double x0, double y0, double x1, double y1, Colour colour, double width) const
    {
        cairo_move_to(cairo, x0, y0);
        cairo_line_to(cairo, x1, y1);
        set_colour(cairo, colour);
        cairo_set_line_width(cairo, width);
        cairo_stroke(cairo);
    }
};

void draw_axes(const Frame& frame)
{
    const Box& box = frame.box;
    for (int theta = 0; theta <= 90; theta += 15) {
        const double x = frame.x(theta);
        frame.draw_line(x, box.y, x, box.y + box.height, line, 0.6);
        draw_text(frame.cairo, label, x, box.y + box.height + 15, fmt::format("{}°", theta),
                  Align::centre);
    }
    const double step = frame.greatest > 1.25 ? 0.5 : 0.2;
    for (int k = 0; k * step <= frame.greatest + 1e-9; ++k) {
        const double y = frame.y(k * step);
        const bool is_one = std::abs(k * step - 1) < 1e-9;
        frame.draw_line(box.x, y, box.x + box.width, y, is_one ? strong : line, is_one ? 1.2 : 0.6);
        draw_text(frame.cairo, label, box.x - 6, y + 4, fmt::format("{:.1f}", k * step),
                  Align::right);
    }
    draw_text(frame.cairo, label, box.x + box.width / 2, box.y + box.height + 32,
              "angle of the light from the normal", Align::centre);
}

void draw_curve(const Frame& frame, std::span<const AlbedoPoint> curve, std::size_t channel,
                Colour colour)
{
    cairo_save(frame.cairo);
    cairo_rectangle(frame.cairo, frame.box.x, frame.box.y, frame.box.width, frame.box.height);
    cairo_clip(frame.cairo);
    for (const AlbedoPoint& point : curve)
        cairo_line_to(frame.cairo, frame.x(point.theta_i),
                      frame.y(std::min(point.albedo[channel], 2 * most_shown)));
    set_colour(frame.cairo, colour);
    cairo_set_line_width(frame.cairo, 1.8);
    cairo_stroke(frame.cairo);
    cairo_restore(frame.cairo);
}

}  // namespace

void draw_albedo(cairo_t* cairo, std::span<const AlbedoPoint> curve, const Box& box)
{
    const AlbedoPoint* peak = &curve[0];
    const auto largest = [](const AlbedoPoint& point) {
        return *std::ranges::max_element(point.albedo);
    };
    for (const AlbedoPoint& point : curve)
        if (largest(point) > largest(*peak)) peak = &point;
    const Frame frame{
        cairo,
        {box.x + left, box.y + top, box.width - left - right, box.height - top - bottom},
        std::clamp(1.05 * largest(*peak), 1.0, most_shown)};
    draw_text(
        cairo, heading, box.x, box.y + 12,
        fmt::format("directional albedo; largest {:.4g} at {}°", largest(*peak), peak->theta_i));
    draw_axes(frame);
    const std::size_t count = std::min(curve[0].albedo.size(), channels.size());
    for (std::size_t c = 0; c < count; ++c)
        draw_curve(frame, curve, c, count == 1 ? single : channels[c]);
}

}  // namespace gonio

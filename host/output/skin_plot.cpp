// SPDX-License-Identifier: Apache-2.0
// Draws axes, curves and swatches.
#include "output/skin_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gonio/colour.hpp"
#include "output/page.hpp"

namespace gonio {
namespace {

constexpr double width = 1020, height = 480, margin = 24, header = 74;
constexpr Box plot{64, header + 10, 620, height - header - 66};
constexpr double swatch_left = 716, gap = 8, largest_swatch = 96, three_lines = 44, spacing = 15;
constexpr Colour line = hex(0xd5d8dc), edge = hex(0x3c4043), grey = hex(0x9aa0a6);
constexpr Font title_font{18, true, hex(0x202124)}, small{12, false, hex(0x5f6368)},
    label{10.5, false, hex(0x5f6368)}, strong{12, true, hex(0x202124)};

/// The way from numbers to the page.
struct Frame {
    double first, last, greatest;

    double x(double wavelength) const
    {
        return plot.x + plot.width * (wavelength - first) / (last - first);
    }
    double y(double reflectance) const
    {
        return plot.y + plot.height * (1 - reflectance / greatest);
    }
};

Frame frame_of(const std::vector<PlottedSpectrum>& spectra)
{
    Frame frame{1e9, 0, 0.1};
    for (const PlottedSpectrum& spectrum : spectra) {
        frame.first = std::min(frame.first, spectrum.wavelengths.front());
        frame.last = std::max(frame.last, spectrum.wavelengths.back());
        frame.greatest = std::max(frame.greatest, *std::ranges::max_element(spectrum.reflectance));
    }
    if (frame.first == frame.last) {
        frame.first -= 10;
        frame.last += 10;
    }
    frame.greatest = std::ceil(frame.greatest * 10 + 0.2) / 10;
    return frame;
}

void stroke(cairo_t* cairo, Colour colour, double thickness)
{
    set_colour(cairo, colour);
    cairo_set_line_width(cairo, thickness);
    cairo_stroke(cairo);
}

void draw_axes(cairo_t* cairo, const Frame& frame)
{
    const double step = frame.last - frame.first > 150  ? 50
                        : frame.last - frame.first > 40 ? 10
                                                        : 5;
    for (double at = std::ceil(frame.first / step) * step; at <= frame.last; at += step) {
        cairo_move_to(cairo, frame.x(at), plot.y);
        cairo_line_to(cairo, frame.x(at), plot.y + plot.height);
        stroke(cairo, line, 0.6);
        draw_text(cairo, label, frame.x(at), plot.y + plot.height + 16, fmt::format("{}", at),
                  Align::centre);
    }
    for (int tenth = 0; tenth <= std::lround(10 * frame.greatest); ++tenth) {
        const double y = frame.y(tenth / 10.0);
        cairo_move_to(cairo, plot.x, y);
        cairo_line_to(cairo, plot.x + plot.width, y);
        stroke(cairo, line, 0.6);
        draw_text(cairo, label, plot.x - 8, y + 4, fmt::format("{:.1f}", tenth / 10.0),
                  Align::right);
    }
    draw_text(cairo, label, plot.x + plot.width / 2, plot.y + plot.height + 36, "wavelength, nm",
              Align::centre);
    draw_text(cairo, label, plot.x - 40, plot.y - 8, "reflectance");
}

/// Light colours need an edge to be seen on white.
void draw_curve(cairo_t* cairo, const Frame& frame, const PlottedSpectrum& spectrum, Colour colour)
{
    if (spectrum.dotted) {
        for (std::size_t k = 0; k < spectrum.wavelengths.size(); ++k) {
            cairo_arc(cairo, frame.x(spectrum.wavelengths[k]), frame.y(spectrum.reflectance[k]),
                      1.6, 0, 2 * std::numbers::pi);
            set_colour(cairo, edge);
            cairo_fill(cairo);
        }
        return;
    }
    for (const auto& [tint, thickness] : {std::pair{edge, 3.4}, std::pair{colour, 2.2}}) {
        for (std::size_t k = 0; k < spectrum.wavelengths.size(); ++k)
            cairo_line_to(cairo, frame.x(spectrum.wavelengths[k]),
                          frame.y(spectrum.reflectance[k]));
        stroke(cairo, tint, thickness);
    }
}

void draw_swatch(cairo_t* cairo, const PlottedSpectrum& spectrum, Colour colour, double y,
                 double side)
{
    rounded_box(cairo, {swatch_left, y, side, side}, 4);
    set_colour(cairo, colour);
    cairo_fill_preserve(cairo);
    stroke(cairo, line, 1);
    const double left = swatch_left + side + 12, room = width - margin - left;
    std::vector<std::string> lines;
    if (has_colour(spectrum.wavelengths) && side >= three_lines) {
        const auto of = colour_of(spectrum.wavelengths, spectrum.reflectance);
        lines.push_back(fmt::format("sRGB {} {} {}", of.srgb.x, of.srgb.y, of.srgb.z));
        lines.push_back(fmt::format("L* {:.1f}  a* {:.1f}  b* {:.1f}  ITA {:.0f}°", of.lab.x,
                                    of.lab.y, of.lab.z, std::round(of.typology_angle) + 0.0));
    }
    double baseline = y + side / 2 + 4 - spacing * static_cast<double>(lines.size()) / 2;
    draw_text(cairo, strong, left, baseline, spectrum.label, Align::left, room);
    for (const std::string& text : lines)
        draw_text(cairo, label, left, baseline += spacing, text, Align::left, room);
}

Colour shown_colour(const PlottedSpectrum& spectrum)
{
    if (!has_colour(spectrum.wavelengths)) return grey;
    return Colour(colour_of(spectrum.wavelengths, spectrum.reflectance).srgb) / 255.0;
}

}  // namespace

void write_skin_plot(const std::filesystem::path& path, const std::string& title,
                     const std::string& subtitle, const std::vector<PlottedSpectrum>& spectra)
{
    Page page(path, width, height);
    cairo_t* cairo = page.cairo();
    draw_text(cairo, title_font, margin, 34, title, Align::left, width - 2 * margin);
    draw_text(cairo, small, margin, 54, subtitle, Align::left, width - 2 * margin);
    const Frame frame = frame_of(spectra);
    draw_axes(cairo, frame);
    const auto count = static_cast<double>(spectra.size());
    const double side = std::min(largest_swatch, (plot.height - gap * (count - 1)) / count);
    double y = plot.y;
    for (const PlottedSpectrum& spectrum : spectra) {
        const Colour colour = shown_colour(spectrum);
        draw_curve(cairo, frame, spectrum, colour);
        draw_swatch(cairo, spectrum, colour, y, side);
        y += side + gap;
    }
    page.save();
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The plots of a report as pictures.
#include <algorithm>
#include <array>
#include <cmath>

#include "output/page.hpp"
#include "output/plot_axes.hpp"
#include "timings/report.hpp"

namespace gonio {
namespace {

constexpr double width = 760, height = 470;
constexpr Box plot_box{78, 74, 470, 330};
constexpr double legend = 568;
constexpr std::array colours{hex(0x3b5a7a), hex(0xd8504a), hex(0x3a9a55), hex(0x8a63b8),
                             hex(0xc98a1b), hex(0x2a9aa8), hex(0x8c564b), hex(0x6b6b6b),
                             hex(0xc2519c), hex(0x7f9a1b)};
constexpr Colour ink = hex(0x202124), grey = hex(0x5f6368);

/// What a logarithmic axis can show.
bool is_shown(const BenchPlot& plot, const BenchPoint& point)
{
    return !(plot.x_logarithmic && point.x.median <= 0) &&
           !(plot.y_logarithmic && point.y.median <= 0);
}

/// From the numbers themselves, with some room around them.
Scale scale_of(const BenchPlot& plot, Quartiles BenchPoint::*which, bool logarithmic)
{
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (const BenchPoint& point : plot.points) {
        if (!is_shown(plot, point)) continue;
        least = std::min(least, (point.*which).median);
        greatest = std::max(greatest, (point.*which).median);
    }
    if (!(least <= greatest)) return {1, 10, logarithmic};
    if (logarithmic) return {least / 1.6, greatest * 1.6, true};
    const double room = 0.05 * (greatest - std::min(least, 0.0));
    return {std::min(least, 0.0) - room, greatest + room, false};
}

void draw_points(const Axes& axes, const BenchPlot& plot, const std::string& series, Colour colour)
{
    cairo_t* cairo = axes.cairo;
    set_colour(cairo, colour);
    cairo_set_line_width(cairo, 1.2);
    cairo_new_path(cairo);
    for (const BenchPoint& point : plot.points)
        if (plot.joined && point.series == series && is_shown(plot, point))
            cairo_line_to(cairo, axes.x(point.x.median), axes.y(point.y.median));
    cairo_stroke(cairo);
    for (const BenchPoint& point : plot.points) {
        if (point.series != series || !is_shown(plot, point)) continue;
        const double x = axes.x(point.x.median), y = axes.y(point.y.median);
        cairo_arc(cairo, x, y, 2.6, 0, 6.3);
        cairo_fill(cairo);
        if (point.best) {
            cairo_arc(cairo, x, y, 5.5, 0, 6.3);
            cairo_stroke(cairo);
        }
        if (plot.joined) continue;
        const bool leftwards = x > plot_box.x + plot_box.width * 3 / 4;
        draw_text(cairo, {7.5, false, colour}, leftwards ? x - 5 : x + 5, y - 3, point.label,
                  leftwards ? Align::right : Align::left);
    }
}

}  // namespace

void write_bench_plot(const std::filesystem::path& path, const BenchPlot& plot)
{
    Page page(path, width, height);
    cairo_t* cairo = page.cairo();
    draw_text(cairo, {15, true, ink}, 20, 28, plot.title, Align::left, width - 40);
    const Axes axes{cairo, plot_box,
                    plot.x_names.empty() ? scale_of(plot, &BenchPoint::x, plot.x_logarithmic)
                                         : Scale(plot.x_names),
                    scale_of(plot, &BenchPoint::y, plot.y_logarithmic)};
    axes.draw(plot.x_title, plot.y_title);
    std::vector<std::string> names;
    for (const BenchPoint& point : plot.points)
        if (std::ranges::find(names, point.series) == names.end()) names.push_back(point.series);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const Colour colour = colours[k % colours.size()];
        draw_points(axes, plot, names[k], colour);
        draw_text(cairo, {10.5, true, colour}, legend, plot_box.y + 12 + 17 * double(k), names[k],
                  Align::left, width - legend - 8);
    }
    if (std::ranges::any_of(plot.points, &BenchPoint::best))
        draw_text(cairo, {10.5, false, grey}, legend, plot_box.y + plot_box.height,
                  "ringed: nothing beats it");
    page.save();
}

}  // namespace gonio

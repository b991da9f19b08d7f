// SPDX-License-Identifier: Apache-2.0
// Pictures of tables.
#include "output/table_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "gonio/errors.hpp"
#include "output/page.hpp"
#include "output/plot_axes.hpp"

namespace gonio {
namespace {

constexpr double width = 640, height = 420;
constexpr Box plot{72, 74, 540, 290}, narrow{72, 74, 440, 290}, bar{540, 74, 16, 290};
constexpr double much = 30;         // spans more: by its logarithm
constexpr double most_decades = 6;  // shown below the largest
constexpr std::array curve_colours{hex(0x3b5a7a), hex(0xd8504a), hex(0x3a9a55), hex(0x8a63b8),
                                   hex(0xc98a1b)};
/// Dark to light, about even in lightness.
constexpr std::array map_colours{hex(0x1d1147), hex(0x5c1a72), hex(0xa52c60),
                                 hex(0xe4593a), hex(0xfb9d07), hex(0xf9f871)};

std::string title_of(const Axis& axis)
{
    return axis.unit.empty() || axis.unit == "1" ? axis.name
                                                 : fmt::format("{}, {}", axis.name, axis.unit);
}

/// Of the values above 0.
Scale scale_of(const std::vector<double>& values)
{
    const double greatest = *std::ranges::max_element(values);
    double least = greatest;
    for (const double value : values)
        if (value > 0) least = std::min(least, value);
    if (!(greatest > 0)) return {0, 1, false};
    if (greatest < much * least) return {0, greatest, false};
    return {std::max(least, greatest * std::pow(10, -most_decades)), greatest, true};
}

std::size_t error_of(const TableHeader& header, std::size_t channel)
{
    const auto& names = header.channels;
    return static_cast<std::size_t>(std::ranges::find(names, names[channel] + ".error") -
                                    names.begin());
}

void draw_curve(const Axes& axes, const Table& table, std::size_t channel, Colour colour)
{
    const std::vector<double>& at = table.header.axes[0].values;
    const std::vector<double>& values = table.values[channel];
    const std::size_t error = error_of(table.header, channel);
    cairo_t* cairo = axes.cairo;
    cairo_save(cairo);
    cairo_rectangle(cairo, axes.box.x, axes.box.y, axes.box.width, axes.box.height);
    cairo_clip(cairo);
    const auto place = [&](std::size_t k, double value) {
        const double y = axes.y(value);
        cairo_line_to(cairo, axes.x(at[k]),
                      std::isfinite(y) ? y : axes.box.y + axes.box.height + 10);
    };
    if (error < table.values.size()) {
        for (std::size_t k = 0; k < at.size(); ++k) place(k, values[k] + table.values[error][k]);
        for (std::size_t k = at.size(); k-- > 0;)
            place(k, std::max(0.0, values[k] - table.values[error][k]));
        set_colour(cairo, colour, 0.3);
        cairo_fill(cairo);
    }
    for (std::size_t k = 0; k < at.size(); ++k) place(k, values[k]);
    set_colour(cairo, colour);
    cairo_set_line_width(cairo, 1.4);
    cairo_stroke(cairo);
    cairo_restore(cairo);
}

void draw_curves(cairo_t* cairo, const Table& table)
{
    const Axis& axis = table.header.axes[0];
    std::vector<std::size_t> shown;
    std::vector<double> all;
    for (std::size_t c = 0; c < table.values.size(); ++c) {
        if (table.header.channels[c].ends_with(".error")) continue;
        shown.push_back(c);
        all.insert(all.end(), table.values[c].begin(), table.values[c].end());
    }
    const auto [least, greatest] = std::ranges::minmax(axis.values);
    const Axes axes{cairo, plot, {least, greatest, false}, scale_of(all)};
    axes.draw(title_of(axis), table.header.unit);
    double x = plot.x + plot.width;
    for (std::size_t k = shown.size(); k-- > 0;) {
        const Colour colour = curve_colours[k % curve_colours.size()];
        draw_curve(axes, table, shown[k], colour);
        if (shown.size() == 1) continue;
        draw_text(cairo, {10.5, true, colour}, x, plot.y - 10, table.header.channels[shown[k]],
                  Align::right, 90);
        x -= 96;
    }
}

Colour map_colour(double part)
{
    const double place = std::clamp(part, 0.0, 1.0) * (map_colours.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(place), map_colours.size() - 2);
    return glm::mix(map_colours[k], map_colours[k + 1], place - static_cast<double>(k));
}

/// The edges of cells around an axis' values.
std::vector<double> edges(const std::vector<double>& at)
{
    std::vector<double> all{at.front()};
    for (std::size_t k = 1; k < at.size(); ++k) all.push_back((at[k - 1] + at[k]) / 2);
    all.push_back(at.back());
    if (at.size() == 1) return {at[0] - 0.5, at[0] + 0.5};
    all.front() -= all[1] - at.front();
    all.back() += at.back() - all[at.size() - 1];
    return all;
}

void fill(cairo_t* cairo, double x0, double y0, double x1, double y1, Colour colour)
{
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);  // no seams where edges fall into a pixel
    cairo_rectangle(cairo, std::min(x0, x1), std::min(y0, y1), std::abs(x1 - x0),
                    std::abs(y1 - y0));
    set_colour(cairo, colour);
    cairo_fill(cairo);
}

/// The inner axis goes across, the outer one down.
void draw_map(cairo_t* cairo, const Table& table)
{
    const Axis &outer = table.header.axes[0], &inner = table.header.axes[1];
    const std::vector<double> rows = edges(outer.values), columns = edges(inner.values);
    const std::vector<double>& values = table.values[0];
    const Scale colours = scale_of(values);
    const Axes axes{cairo,
                    narrow,
                    {columns.front(), columns.back(), false},
                    {rows.back(), rows.front(), false}};
    axes.draw(title_of(inner), title_of(outer));
    for (std::size_t r = 0; r < outer.values.size(); ++r)
        for (std::size_t c = 0; c < inner.values.size(); ++c) {
            const double part = colours(values[r * inner.values.size() + c]);
            fill(cairo, axes.x(columns[c]), axes.y(rows[r]), axes.x(columns[c + 1]),
                 axes.y(rows[r + 1]), map_colour(std::isfinite(part) ? part : 0));
        }
    constexpr int steps = 145;
    for (int k = 0; k < steps; ++k)
        fill(cairo, bar.x, bar.y + bar.height * (1 - (k + 1.0) / steps), bar.x + bar.width,
             bar.y + bar.height * (1 - double(k) / steps), map_colour((k + 0.5) / steps));
    for (const auto& [value, text] : colours.ticks())
        draw_text(cairo, {10.5, false, hex(0x5f6368)}, bar.x + bar.width + 6,
                  bar.y + bar.height * (1 - colours(value)) + 4, text);
    draw_text(cairo, {10.5, false, hex(0x5f6368)}, bar.x - 4, bar.y - 10, table.header.unit);
}

}  // namespace

void write_table_plot(const std::filesystem::path& path, const Table& table)
{
    const std::size_t axes = table.header.axes.size();
    if (axes != 1 && axes != 2)
        throw UsageError(
            fmt::format("a plot shows tables of one axis or two, and this one has {}; lookup reads "
                        "values of it",
                        axes));
    Page page(path, width, height);
    const auto* title = table.header.find("title");
    const auto* material = table.header.find("material");
    draw_text(page.cairo(), {15, true, hex(0x202124)}, 20, 28,
              title ? std::get<std::string>(*title) : table.header.quantity, Align::left,
              width - 40);
    if (material)
        draw_text(page.cairo(), {11, false, hex(0x5f6368)}, 20, 46,
                  std::get<std::string>(*material), Align::left, width - 40);
    if (axes == 1)
        draw_curves(page.cairo(), table);
    else
        draw_map(page.cairo(), table);
    page.save();
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Axes of a plot: from numbers to the page, with ticks at round numbers.
#include "output/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio {
namespace {

constexpr Colour line = hex(0xd5d8dc);
constexpr Font label{10.5, false, hex(0x5f6368)};
constexpr double most_ticks = 10;

/// 1, 2 or 5 times a power of ten.
double round_step(double step)
{
    const double power = std::pow(10, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= step) return factor * power;
    return 10 * power;
}

}  // namespace

Scale::Scale(double from, double to, bool logarithmic)
    : from_(logarithmic ? std::log10(from) : from),
      to_(logarithmic ? std::log10(to) : to),
      logarithmic_(logarithmic)
{
    if (from_ != to_) return;
    from_ -= 0.5;
    to_ += 0.5;
}

Scale::Scale(std::vector<std::string> names)
    : from_(0.5),
      to_(0.5 + static_cast<double>(names.size())),
      logarithmic_(false),
      names_(std::move(names))
{
}

double Scale::operator()(double value) const
{
    return ((logarithmic_ ? std::log10(value) : value) - from_) / (to_ - from_);
}

std::vector<std::pair<double, std::string>> Scale::ticks() const
{
    std::vector<std::pair<double, std::string>> all;
    for (const std::string& name : names_)
        all.emplace_back(static_cast<double>(all.size() + 1), name);
    if (!all.empty()) return all;
    double step = round_step((to_ - from_) / most_ticks);
    if (logarithmic_) step = std::max(1.0, std::ceil(step));
    constexpr double slack = 1e-9;
    for (double k = std::ceil(from_ / step - slack); k * step <= to_ + slack * step; ++k) {
        const double at = logarithmic_ ? std::pow(10, k * step) : k * step + 0.0;  // no -0
        all.emplace_back(at, fmt::format("{:.4g}", at));
    }
    return all;
}

void Axes::draw(const std::string& x_title, const std::string& y_title) const
{
    const auto stroke = [&](double x0, double y0, double x1, double y1) {
        cairo_move_to(cairo, x0, y0);
        cairo_line_to(cairo, x1, y1);
        set_colour(cairo, line);
        cairo_set_line_width(cairo, 0.6);
        cairo_stroke(cairo);
    };
    const double right = box.x + box.width, bottom = box.y + box.height;
    for (const auto& [value, text] : across.ticks()) {
        stroke(x(value), box.y, x(value), bottom);
        draw_text(cairo, label, x(value), bottom + 16, text, Align::centre);
    }
    for (const auto& [value, text] : up.ticks()) {
        stroke(box.x, y(value), right, y(value));
        draw_text(cairo, label, box.x - 8, y(value) + 4, text, Align::right);
    }
    draw_text(cairo, label, box.x + box.width / 2, bottom + 36, x_title, Align::centre);
    draw_text(cairo, label, box.x - 40, box.y - 10, y_title);
}

}  // namespace gonio

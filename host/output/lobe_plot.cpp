// SPDX-License-Identifier: Apache-2.0
// The polar plot of a contact sheet: rings, the lobe, where light comes from and would be mirrored.
#include "output/lobe_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "output/tone.hpp"

namespace gonio {
namespace {

constexpr double margin = 10, label_height = 30;
constexpr Colour disc = hex(0xf3f5f7), ring = hex(0xb4b9be), ground = hex(0x8a9096),
                 ink = hex(0x3c4043), arrow = hex(0xe0952c), neutral = hex(0x5f7f9f);
constexpr Font label{10.5, false, hex(0x5f6368)};

/// From the horizon on the light's side, -90 degrees, to the other one; dense at the mirror
/// direction.
std::vector<double> viewing_angles(double theta_i)
{
    std::vector<double> angles;
    for (int k = -180; k <= 180; ++k) angles.push_back(0.5 * k);
    constexpr int steps = 90;
    for (int k = -steps; k <= steps; ++k)
        angles.push_back(
            std::min(theta_i + 45 * std::pow(static_cast<double>(k) / steps, 3), 90.0));
    std::ranges::sort(angles);
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

/// A half disc on the page.
struct Plot {
    cairo_t* cairo;
    double x, y;     ///< the point that the light hits
    double radius;   ///< of the outermost ring
    double peak;     ///< the BRDF there, 1/sr
    double theta_i;  ///< of the light, degrees

    double radius_of(double brdf) const { return radius * std::cbrt(brdf / peak); }

    void add_point(double theta, double r) const
    {
        const double angle = theta * std::numbers::pi / 180;
        cairo_line_to(cairo, x + r * std::sin(angle), y - r * std::cos(angle));
    }

    void stroke(Colour colour, double width) const
    {
        set_colour(cairo, colour);
        cairo_set_line_width(cairo, width);
        cairo_stroke(cairo);
    }

    void draw_ray(double theta, double from, double to, Colour colour, double width) const
    {
        add_point(theta, from);
        add_point(theta, to);
        stroke(colour, width);
    }
};

void draw_rings(const Plot& plot)
{
    const double pi = std::numbers::pi;
    cairo_arc(plot.cairo, plot.x, plot.y, plot.radius, -pi, 0);
    set_colour(plot.cairo, disc);
    cairo_fill_preserve(plot.cairo);
    plot.stroke(ring, 1);
    for (int theta = -60; theta <= 60; theta += 30) plot.draw_ray(theta, 0, plot.radius, ring, 0.6);
    double free_below = plot.radius - 8;
    for (int decade = static_cast<int>(std::floor(std::log10(plot.peak)));; --decade) {
        const double value = std::pow(10, decade), r = plot.radius_of(value);
        if (r < 16) break;
        cairo_arc(plot.cairo, plot.x, plot.y, r, -pi, 0);
        plot.stroke(ring, 0.6);
        if (r > free_below || r < 26) continue;
        for (const double x : {plot.x - r, plot.x + r})
            draw_text(plot.cairo, label, x, plot.y + 15, fmt::format("{:g}", value), Align::centre);
        free_below = r - 34;
    }
}

void trace(const Plot& plot, std::span<const glm::vec3> brdf,
           const std::function<float(glm::vec3)>& value)
{
    const std::vector<double> thetas = viewing_angles(plot.theta_i);
    plot.add_point(0, 0);
    for (std::size_t k = 0; k < thetas.size(); ++k)
        plot.add_point(thetas[k], plot.radius_of(value(brdf[k])));
    cairo_close_path(plot.cairo);
}

bool is_grey(glm::vec3 colour)
{
    return std::min({colour.x, colour.y, colour.z}) >= 0.99f * greatest(colour);
}

/// Dark enough to be seen on white.
Colour tint_of(glm::vec3 colour)
{
    const glm::vec3 tint = 0.62f * colour / greatest(colour);
    return {encode(tint.x), encode(tint.y), encode(tint.z)};
}

/// Filled to the greatest channel; a line for each channel if there is colour.
void draw_curves(const Plot& plot, std::span<const glm::vec3> brdf)
{
    glm::vec3 sum(0);
    for (const glm::vec3 value : brdf) sum += value / (1 + greatest(value));
    const bool grey = is_grey(sum);
    const Colour colour = grey ? neutral : tint_of(sum);
    const Pattern fill(cairo_pattern_create_radial(plot.x, plot.y, 0, plot.x, plot.y, plot.radius));
    add_stop(fill.get(), 0, colour, 0.4);
    add_stop(fill.get(), 1, colour, 0.75);
    trace(plot, brdf, greatest);
    cairo_set_source(plot.cairo, fill.get());
    cairo_fill(plot.cairo);
    const std::array lines{hex(0xd8504a), hex(0x3a9a55), hex(0x3f82e4)};
    for (int c = 0; c < (grey ? 1 : 3); ++c) {
        trace(plot, brdf, [c](glm::vec3 value) { return value[c]; });
        plot.stroke(grey ? 0.62 * neutral : lines[static_cast<std::size_t>(c)], 1.4);
    }
}

void draw_directions(const Plot& plot)
{
    plot.draw_ray(-90, plot.radius + 8, 0, ground, 1.5);
    plot.draw_ray(90, plot.radius + 8, 0, ground, 1.5);
    const std::array dashes{4.0, 3.0};
    cairo_set_dash(plot.cairo, dashes.data(), 2, 0);
    plot.draw_ray(plot.theta_i, 0, plot.radius + 8, ink, 1);
    cairo_set_dash(plot.cairo, nullptr, 0, 0);

    plot.draw_ray(-plot.theta_i, plot.radius + 8, 9, arrow, 2);
    plot.add_point(0, 0);
    plot.add_point(-plot.theta_i - 16, 12);
    plot.add_point(-plot.theta_i + 16, 12);
    set_colour(plot.cairo, arrow);
    cairo_fill(plot.cairo);
}

}  // namespace

std::vector<DirectionPair> lobe_pairs(double theta_i)
{
    std::vector<DirectionPair> pairs;
    for (const double theta : viewing_angles(theta_i))
        pairs.push_back({theta_i, 180, std::abs(theta), theta < 0 ? 180.0 : 0.0});
    return pairs;
}

double lobe_plot_height(double width)
{
    return width / 2 + label_height;
}

void draw_lobe(cairo_t* cairo, std::span<const glm::vec3> brdf, double theta_i, double x, double y,
               double width)
{
    float peak = 0;
    for (const glm::vec3 value : brdf) peak = std::max(peak, greatest(value));
    const Plot plot{cairo,  x + width / 2, y + width / 2, width / 2 - margin, peak > 0 ? peak : 1,
                    theta_i};
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    draw_rings(plot);
    draw_curves(plot, brdf);
    draw_directions(plot);
    const auto text = peak < 1000 ? fmt::format("{:.3g}", peak) : fmt::format("{:.0f}", peak);
    draw_text(cairo, label, plot.x, plot.y + label_height - 1, fmt::format("peak {} sr⁻¹", text),
              Align::centre);
}

}  // namespace gonio

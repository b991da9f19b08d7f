// SPDX-License-Identifier: Apache-2.0
// Lays out the page and evaluates the reference for all that is drawn.
#include "output/model_plot.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "output/albedo_plot.hpp"
#include "output/contact_sheet.hpp"
#include "output/lobe_plot.hpp"
#include "output/page.hpp"
#include "output/tone.hpp"

namespace gonio {
namespace {

constexpr double width = 1020, margin = 24, header = 92, lobe_width = 300, gap = 18, caption = 20;
constexpr std::array angles{15.0, 45.0, 65.0, 80.0};  // of the light, degrees
constexpr Font title{18, true, hex(0x202124)}, small{12, false, hex(0x5f6368)},
    heading{12, true, hex(0x202124)};

/// f of the reference in 1/sr, as the plot wants it; 0 where there is no limit on the horizon.
std::vector<glm::vec3> values_of(const Material& material, const std::vector<DirectionPair>& pairs)
{
    const Reference f = make_reference(material, Measure::brdf);
    std::vector<std::vector<float>> planes(material.channels());
    for (const DirectionPair& pair : pairs) {
        const auto [l, v] = unit_vectors(pair);
        for (std::size_t c = 0; c < planes.size(); ++c) {
            const double value = f(l, v, c);
            planes[c].push_back(std::isfinite(value) ? static_cast<float>(value) : 0);
        }
    }
    return as_rgb(planes);
}

void draw_header(cairo_t* cairo, const Material& material)
{
    const ContactCard card = make_card(material);
    const Model& model = *material.lobes[0].model;
    draw_text(cairo, title, margin, 34, fmt::format("{}: {}", material.name, model.title));
    draw_text(cairo, small, margin, 54, std::string(model.citation), Align::left,
              width - 2 * margin);
    draw_paragraph(cairo, small, margin, 72, card.subtitle, width - 2 * margin, 2);
}

}  // namespace

void write_model_plot(const std::filesystem::path& path, const Material& material)
{
    const double cell = caption + lobe_plot_height(lobe_width) + gap;
    const double height = header + 2 * cell + margin;
    Page page(path, width, height);
    draw_header(page.cairo(), material);
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const std::size_t column = k % 2, row = k / 2;
        const double x = margin + static_cast<double>(column) * (lobe_width + gap);
        const double y = header + static_cast<double>(row) * cell;
        draw_text(page.cairo(), heading, x, y + 12, fmt::format("light at {}°", angles[k]));
        draw_lobe(page.cairo(), values_of(material, lobe_pairs(angles[k])), angles[k], x,
                  y + caption, lobe_width);
    }
    const double left = margin + 2 * (lobe_width + gap);
    draw_albedo(page.cairo(), albedo_curve(material),
                {left, header, width - margin - left, 2 * cell - gap - caption});
    draw_text(page.cairo(), small, margin, height - 14,
              "f in the plane of incidence along x: the radius is the cube root of f, rings in "
              "sr⁻¹; the mirror direction is dashed.");
    page.save();
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Lays out the cards of a contact sheet and evaluates each material once for all that is drawn.
#include "output/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "gonio/compute.hpp"
#include "gonio/errors.hpp"
#include "output/canvas.hpp"
#include "output/lobe_plot.hpp"
#include "output/sphere.hpp"
#include "output/tone.hpp"

namespace gonio {
namespace {

// In points; a picture has `scale` pixels for each.
constexpr double scale = 1.25, gap = 20, padding = 22, card_width = 580, card_height = 272,
                 corner = 10;
constexpr int sphere_pixels = 260;
constexpr double lobe_light = 45;  // degrees
constexpr Colour page = hex(0xe9ecef), paper = hex(0xffffff), ink = hex(0x202124),
                 shade = hex(0x101418);
constexpr Font title{18, true, ink}, small{12, false, hex(0x5f6368)};
constexpr auto legend =
    "Spheres: a light from the upper left, faint ones from below and behind; each is exposed for "
    "itself.\nLobes: f in the plane of incidence along x; light at 45° (arrow), its mirror "
    "direction dashed; radius ∝ ∛f, rings in sr⁻¹.";

void draw_paper(cairo_t* cairo, const Box& card)
{
    rounded_box(cairo, {card.x, card.y + 2, card.width, card.height}, corner);
    set_colour(cairo, ink, 0.12);
    cairo_fill(cairo);
    rounded_box(cairo, card, corner);
    set_colour(cairo, paper);
    cairo_fill(cairo);
}

/// The sphere's backdrop and its shadow on the ground: a square of the card's height.
void draw_studio(cairo_t* cairo, const Box& card)
{
    cairo_save(cairo);
    cairo_rectangle(cairo, card.x, card.y, card.height, card.height);
    cairo_clip(cairo);
    rounded_box(cairo, card, corner);
    const Pattern wall(cairo_pattern_create_linear(0, card.y, 0, card.y + card.height));
    add_stop(wall.get(), 0.0, hex(0x9aa1a9));
    add_stop(wall.get(), 0.72, hex(0xc9ced3));
    add_stop(wall.get(), 0.80, hex(0xc3c8cd));
    add_stop(wall.get(), 1.0, hex(0xa9b0b7));
    cairo_set_source(cairo, wall.get());
    cairo_fill(cairo);
    cairo_translate(cairo, card.x + card.height / 2 + 14, card.y + card.height - 31);
    cairo_scale(cairo, 1, 0.16);
    const Pattern shadow(cairo_pattern_create_radial(0, 0, 0, 0, 0, 108));
    add_stop(shadow.get(), 0.0, shade, 0.75);
    add_stop(shadow.get(), 0.5, shade, 0.40);
    add_stop(shadow.get(), 1.0, shade, 0.0);
    cairo_set_source(cairo, shadow.get());
    cairo_paint(cairo);
    cairo_restore(cairo);
}

void draw_sphere(cairo_t* cairo, const Box& card, cairo_surface_t* sphere)
{
    const double margin = (card.height - sphere_pixels / scale) / 2;
    cairo_save(cairo);
    cairo_translate(cairo, card.x + margin, card.y + margin);
    cairo_scale(cairo, 1 / scale, 1 / scale);
    cairo_set_source_surface(cairo, sphere, 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
}

/// brdf: of the sphere's pairs, then of the lobe's.
void draw_card(cairo_t* cairo, const Box& box, const ContactCard& card, const Sphere& sphere,
               std::span<const glm::vec3> brdf)
{
    draw_paper(cairo, box);
    draw_studio(cairo, box);
    const Surface image =
        sphere.image(brdf.first(sphere.pairs().size()), rgb_of(card.material.ambient));
    draw_sphere(cairo, box, image.get());
    const double left = box.x + box.height + padding;
    const double width = box.width - box.height - 2 * padding;
    draw_text(cairo, title, left, box.y + 32, card.title, Align::left, width);
    draw_paragraph(cairo, small, left, box.y + 53, card.subtitle, width, 3);
    draw_lobe(cairo, brdf.subspan(sphere.pairs().size()), lobe_light, left,
              box.y + box.height - 8 - lobe_plot_height(width), width);
}

/// Three cards a column or more, so that few are large.
struct Layout {
    std::size_t columns, rows;
    double footer;  ///< two lines of legend, or four in a narrow sheet
    double width, height;

    explicit Layout(std::size_t cards)
        : columns(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(cards) / 3)))),
          rows((cards + columns - 1) / columns),
          footer(columns == 1 ? 80 : 48),
          width(gap + static_cast<double>(columns) * (card_width + gap)),
          height(gap + static_cast<double>(rows) * (card_height + gap) + footer)
    {
    }

    Box box(std::size_t card) const
    {
        const std::size_t row = card / columns, column = card % columns;
        return {gap + static_cast<double>(column) * (card_width + gap),
                gap + static_cast<double>(row) * (card_height + gap), card_width, card_height};
    }
};

}  // namespace

void write_contact_sheet(const std::filesystem::path& path, const Device& device,
                         const std::vector<ContactCard>& cards)
{
    if (cards.empty()) throw UsageError("a contact sheet needs a material");
    const Layout layout(cards.size());
    const Surface sheet = make_image(CAIRO_FORMAT_RGB24, static_cast<int>(scale * layout.width),
                                     static_cast<int>(scale * layout.height));
    const Context context = make_context(sheet.get());
    cairo_t* cairo = context.get();
    cairo_scale(cairo, scale, scale);
    set_colour(cairo, page);
    cairo_paint(cairo);

    const Sphere sphere(sphere_pixels);
    std::vector<DirectionPair> pairs = sphere.pairs();
    std::ranges::copy(lobe_pairs(lobe_light), std::back_inserter(pairs));
    for (std::size_t k = 0; k < cards.size(); ++k) {
        const auto brdf = as_rgb(compute_points(device, cards[k].material, Measure::brdf, pairs));
        draw_card(cairo, layout.box(k), cards[k], sphere, brdf);
    }
    draw_paragraph(cairo, small, gap + 4, layout.height - layout.footer + 12, legend,
                   layout.width - 2 * gap - 8, 4);
    save(path, cairo);
}

}  // namespace gonio

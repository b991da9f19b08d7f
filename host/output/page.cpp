// SPDX-License-Identifier: Apache-2.0
// Cairo's surfaces of pixels and of shapes.
#include "output/page.hpp"

#include <cairo-svg.h>
#include <fmt/format.h>

#include <cmath>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"

namespace gonio {
namespace {

constexpr double pixels_per_point = 1.5;

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count)
{
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

bool is_svg(const std::filesystem::path& path)
{
    const std::string extension = path.extension().string();
    if (extension != ".svg" && extension != ".png")
        throw UsageError(
            fmt::format("{}: the name tells the format; allowed are .png and .svg", path.string()));
    return extension == ".svg";
}

}  // namespace

Page::Page(std::filesystem::path path, double width, double height) : path_(std::move(path))
{
    const double scale = is_svg(path_) ? 1 : pixels_per_point;
    if (is_svg(path_))
        surface_.reset(cairo_svg_surface_create_for_stream(append, &svg_, width, height));
    else
        surface_ = make_image(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(scale * width)),
                              static_cast<int>(std::lround(scale * height)));
    context_ = make_context(surface_.get());
    cairo_scale(cairo(), scale, scale);
    set_colour(cairo(), {1, 1, 1});
    cairo_paint(cairo());
}

void Page::save()
{
    if (!is_svg(path_)) return gonio::save(path_, cairo());
    cairo_surface_finish(surface_.get());
    for (const cairo_status_t status :
         {cairo_status(cairo()), cairo_surface_status(surface_.get())})
        if (status != CAIRO_STATUS_SUCCESS)
            throw RunError(
                fmt::format("{}: cannot draw: {}", path_.string(), cairo_status_to_string(status)));
    write_file(path_, svg_);
}

}  // namespace gonio

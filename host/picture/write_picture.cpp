// SPDX-License-Identifier: Apache-2.0
// Pictures as files: what was computed, and what a screen shows.
#include <fmt/format.h>

#include <cmath>

#include "gonio/errors.hpp"
#include "gonio/picture.hpp"
#include "output/png.hpp"
#include "output/tone.hpp"

namespace gonio {
namespace {

void write_png(const std::filesystem::path& path, const Table& picture,
               const std::optional<double>& exposure)
{
    std::vector<std::vector<float>> planes;
    for (const auto& plane : picture.values) planes.emplace_back(plane.begin(), plane.end());
    const std::vector<glm::vec3> radiance = as_rgb(planes);
    const float factor = exposure ? static_cast<float>(*exposure) : exposure_of(radiance);
    std::vector<std::uint8_t> bytes;
    for (const glm::vec3 value : radiance) {
        const glm::vec3 shown = to_screen(factor * value);
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * shown[c])));
    }
    const TableHeader& header = picture.header;
    gonio::write_png(path, static_cast<std::uint32_t>(header.row_length()),
                     static_cast<std::uint32_t>(header.rows()), bytes);
}

}  // namespace

void check_picture_name(const std::filesystem::path& path)
{
    if (path.extension() != ".exr" && path.extension() != ".png")
        throw UsageError(
            fmt::format("{}: the name tells the format; allowed are .exr and .png", path.string()));
}

void write_picture(const std::filesystem::path& path, const Table& picture,
                   const std::optional<double>& exposure)
{
    check_picture_name(path);
    if (path.extension() == ".exr") return write_table(path, "exr", picture);
    write_png(path, picture, exposure);
}

}  // namespace gonio

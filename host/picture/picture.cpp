// SPDX-License-Identifier: Apache-2.0
// Makes a picture band by band: rays, then each material at what they met.
#include "gonio/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "picture/skin_layers.hpp"
#include "picture/surface.hpp"
#include "scene/located.hpp"
#include "version.hpp"

namespace gonio {
namespace {

using glm::dvec3;

constexpr std::size_t band_samples = std::size_t{1} << 18;

std::vector<Mesh> read_meshes(const PictureRequest& picture)
{
    std::vector<Mesh> meshes;
    for (const PictureMesh& request : picture.meshes) {
        meshes.push_back(located(request.where, [&] { return read_mesh(request.file); }));
        for (glm::vec3& position : meshes.back().positions)
            position = glm::vec3(request.scale * dvec3(position) + request.translate);
    }
    return meshes;
}

/// What of a material reflects at once.
Material surface_of(const SceneMaterial& material)
{
    const auto* lobes = std::get_if<std::vector<Lobe>>(&material.made_of);
    const auto* skin = std::get_if<Skin>(&material.made_of);
    if ((!lobes && !skin) || !material.sweeps.empty())
        throw UsageError(
            fmt::format("{}material `{}` cannot be in a picture, which takes models, "
                        "sums of lobes and skin, without sweeps",
                        material.where, material.name));
    if (lobes) return {material.name, *lobes, material.ambient};
    return {material.name, {material.surface ? *material.surface : skin_surface(*skin)}, {}};
}

TableHeader header_of(const PictureRequest& picture)
{
    const auto axis = [](const char* name, std::size_t count) {
        return make_axis(name, 0, static_cast<double>(count), count, Samples::centre);
    };
    const auto numbers = [](dvec3 v) { return std::vector{v.x, v.y, v.z}; };
    TableHeader header{.quantity = "radiance",
                       .unit = "1/sr",
                       .axes = {axis("y", picture.height), axis("x", picture.width)},
                       .channels = {"R", "G", "B"},
                       .attributes = {}};
    for (Axis& each : header.axes) each.unit = "px";
    header.attributes = {{"program", std::string(GONIO_PROGRAM)},
                         {"colours", std::string("linear sRGB (IEC 61966-2-1, D65)")},
                         {"samples", static_cast<double>(picture.samples * picture.samples)},
                         {"camera.from", numbers(picture.camera.from)},
                         {"camera.to", numbers(picture.camera.to)},
                         {"camera.up", numbers(picture.camera.up)},
                         {"camera.field_of_view", picture.camera.field_of_view}};
    return header;
}

/// The samples of each material.
std::map<std::size_t, std::vector<Sample>> by_material(const PictureRequest& picture,
                                                       const std::vector<Sample>& samples)
{
    std::map<std::size_t, std::vector<Sample>> groups;
    for (const Sample& sample : samples)
        groups[picture.meshes[sample.hit.mesh].material].push_back(sample);
    return groups;
}

}  // namespace

Table make_picture(const Device& device, const PictureRequest& picture,
                   const std::vector<SceneMaterial>& materials)
{
    const Geometry geometry(read_meshes(picture));
    const Rays rays(picture);
    std::map<std::size_t, Surface> surfaces;
    std::map<std::size_t, SkinLayers> layers;
    for (const PictureMesh& mesh : picture.meshes) {
        const std::size_t which = mesh.material;
        if (surfaces.contains(which)) continue;
        const Material surface = surface_of(materials[which]);
        surfaces.try_emplace(which, device, picture, surface);
        if (const auto* skin = std::get_if<Skin>(&materials[which].made_of))
            layers.try_emplace(which, device, picture, *skin, surface);
    }

    const std::size_t each = picture.samples * picture.samples;
    const std::size_t band = std::max<std::size_t>(1, band_samples / (picture.width * each));
    std::vector<dvec3> image(picture.width * picture.height, picture.background);
    for (std::size_t first = 0; first < picture.height; first += band) {
        const std::vector<Sample> samples =
            rays.meet(geometry, first, std::min(band, picture.height - first));
        for (const auto& [which, group] : by_material(picture, samples)) {
            const auto radiance = surfaces.at(which).radiance(geometry, group);
            for (std::size_t k = 0; k < group.size(); ++k)
                image[group[k].pixel] +=
                    (radiance[k] - picture.background) / static_cast<double>(each);
            if (layers.contains(which)) layers.at(which).enter(geometry, group);
        }
    }
    for (const auto& [which, skin] : layers) skin.leave(image);
    Table table{header_of(picture), std::vector<std::vector<double>>(3)};
    for (const dvec3& pixel : image)
        for (int c = 0; c < 3; ++c) table.values[static_cast<std::size_t>(c)].push_back(pixel[c]);
    return table;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Makes a picture band by band: rays, then each material at what they met.
#include "gonio/picture.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "gonio/scene.hpp"
#include "picture/lights.hpp"
#include "picture/lit_layers.hpp"
#include "picture/picture_material.hpp"
#include "picture/surface.hpp"
#include "picture/work.hpp"
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

/// A material where rays have met it.
struct Drawn {
    Drawn(const Device& device, const PictureRequest& picture, const PictureMaterial& material,
          PictureWork& work)
        : surface(device, picture, material.surface)
    {
        if (!material.bands.empty()) layers.emplace(device, picture, material, work);
    }

    Surface surface;
    std::optional<LitLayers> layers;
};

Table table_of(const PictureRequest& picture, const std::vector<dvec3>& image)
{
    Table table{header_of(picture), std::vector<std::vector<double>>(3)};
    for (const dvec3& pixel : image)
        for (int c = 0; c < 3; ++c) table.values[static_cast<std::size_t>(c)].push_back(pixel[c]);
    return table;
}

}  // namespace

Table make_picture(const Device& device, const PictureRequest& asked,
                   const std::vector<SceneMaterial>& materials, const PictureProgress& after_each)
{
    PictureRequest picture = asked;
    picture.lights = shining(asked.lights);
    std::map<std::size_t, PictureMaterial> shown;
    for (const PictureMesh& mesh : picture.meshes)
        shown.try_emplace(mesh.material,
                          picture_material(materials[mesh.material], !picture.lights.empty()));
    const Geometry geometry(read_meshes(picture));
    const Rays rays(picture);
    PictureWork work(after_each);
    std::map<std::size_t, Drawn> drawn;

    const std::size_t each = picture.samples * picture.samples;
    const std::size_t band = std::max<std::size_t>(1, band_samples / (picture.width * each));
    std::vector<dvec3> image(picture.width * picture.height, picture.background);
    for (std::size_t first = 0; first < picture.height; first += band) {
        const std::size_t rows = std::min(band, picture.height - first);
        const std::vector<Sample> samples = rays.meet(geometry, first, rows);
        for (const auto& [which, group] : by_material(picture, samples)) {
            Drawn& material =
                drawn.try_emplace(which, device, picture, shown.at(which), work).first->second;
            const auto radiance = material.surface.radiance(geometry, group);
            for (std::size_t k = 0; k < group.size(); ++k)
                image[group[k].pixel] +=
                    (radiance[k] - picture.background) / static_cast<double>(each);
            if (material.layers) material.layers->enter(geometry, group);
        }
        work.begin("rays");
        work.advance(static_cast<double>(rows * picture.width * each));
    }
    for (const auto& [which, material] : drawn)
        if (material.layers) material.layers->leave(image, work);
    return table_of(picture, image);
}

}  // namespace gonio

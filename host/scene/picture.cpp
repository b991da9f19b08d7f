// SPDX-License-Identifier: Apache-2.0
// Reads [picture]: size, camera, meshes and lights.
#include "scene/picture.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <limits>

#include "scene/material.hpp"

namespace gonio {
namespace {

constexpr double greatest = 1e12;  // of a length or a radiance: its square is a float
constexpr std::size_t most_pixels = 16384, most_samples = 16;

glm::dvec3 read_vector(const Value& value)
{
    const std::vector<Value> list = value.list();
    if (list.size() != 3)
        value.fail(fmt::format("`{}` has {} numbers; allowed are three: x, y, z", value.name(),
                               list.size()));
    return {list[0].number(-greatest, greatest), list[1].number(-greatest, greatest),
            list[2].number(-greatest, greatest)};
}

glm::dvec3 read_unit_vector(const Value& value)
{
    const glm::dvec3 vector = read_vector(value);
    if (glm::length(vector) == 0) value.fail(fmt::format("`{}` is no direction", value.name()));
    return glm::normalize(vector);
}

/// Linear sRGB: one number for all channels, or three.
glm::dvec3 read_colour(const Value& value)
{
    if (!value.is_list()) return glm::dvec3(value.number(0, greatest));
    const std::vector<Value> list = value.list();
    if (list.size() != 3)
        value.fail(fmt::format("`{}` has {} numbers; allowed is one, or red, green and blue",
                               value.name(), list.size()));
    return {list[0].number(0, greatest), list[1].number(0, greatest), list[2].number(0, greatest)};
}

Camera read_camera(const Value& value)
{
    const Section section(value);
    section.allow({"from", "to", "up", "field_of_view"});
    Camera camera{.from = read_vector(section.at("from")), .to = read_vector(section.at("to"))};
    if (const auto up = section.find("up")) camera.up = read_unit_vector(*up);
    if (const auto angle = section.find("field_of_view"))
        camera.field_of_view = angle->number(1e-3, 179);
    const glm::dvec3 forward = camera.to - camera.from;
    if (glm::length(glm::cross(forward, camera.up)) <= 1e-9 * glm::length(forward))
        section.fail("the camera looks along `up`, or nowhere");
    return camera;
}

PictureMesh read_mesh_request(const Value& value, const std::vector<SceneMaterial>& materials,
                              const std::filesystem::path& folder)
{
    const Section section(value);
    section.allow({"file", "material", "scale", "translate"});
    const Value file = section.at("file");
    PictureMesh mesh{.file = folder / file.text(),
                     .material = find_material(section.at("material"), materials),
                     .where = file.where()};
    if (const auto scale = section.find("scale")) mesh.scale = scale->number(1e-9, 1e9);
    if (const auto translate = section.find("translate")) mesh.translate = read_vector(*translate);
    return mesh;
}

PictureLight read_light(const Value& value)
{
    const Section section(value);
    switch (section.at("kind").choice({"directional", "point", "uniform"})) {
        case 0:
            section.allow({"kind", "towards", "irradiance"});
            return DirectionalLight{read_unit_vector(section.at("towards")),
                                    read_colour(section.at("irradiance"))};
        case 1:
            section.allow({"kind", "position", "intensity"});
            return PointLight{read_vector(section.at("position")),
                              read_colour(section.at("intensity"))};
        default:
            section.allow({"kind", "radiance"});
            return UniformLight{read_colour(section.at("radiance"))};
    }
}

}  // namespace

PictureRequest read_picture(const Value& value, const std::vector<SceneMaterial>& materials,
                            const std::filesystem::path& folder)
{
    const Section section(value);
    section.allow({"title", "width", "height", "samples", "background", "exposure",
                   "metres_per_unit", "photons", "camera", "mesh", "light"});
    PictureRequest picture;
    picture.where = section.where();
    if (const auto title = section.find("title")) picture.title = title->text();
    if (const auto width = section.find("width")) picture.width = width->count(1, most_pixels);
    if (const auto height = section.find("height")) picture.height = height->count(1, most_pixels);
    if (const auto samples = section.find("samples"))
        picture.samples = samples->count(1, most_samples);
    if (const auto background = section.find("background"))
        picture.background = read_colour(*background);
    if (const auto exposure = section.find("exposure"))
        picture.exposure = exposure->number(0, greatest);
    if (const auto metres = section.find("metres_per_unit"))
        picture.metres_per_unit = metres->number(1e-9, 1e9);
    if (const auto photons = section.find("photons"))
        picture.photons = photons->count(1000, 1'000'000'000);
    picture.camera = read_camera(section.at("camera"));
    for (const Value& mesh : section.at("mesh").list())
        picture.meshes.push_back(read_mesh_request(mesh, materials, folder));
    if (const auto lights = section.find("light"))
        for (const Value& light : lights->list()) picture.lights.push_back(read_light(light));
    return picture;
}

}  // namespace gonio

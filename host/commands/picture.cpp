// SPDX-License-Identifier: Apache-2.0
// gonio picture SCENE.toml: the picture that a scene describes.
#include <fmt/format.h>

#include <algorithm>

#include "commands/commands.hpp"
#include "gonio/errors.hpp"
#include "gonio/scene.hpp"

namespace gonio {
namespace {

struct PictureOptions {
    DeviceOptions device;
    std::string scene;
    std::vector<std::string> files;
    std::size_t size = 0;
};

void make(const PictureOptions& options)
{
    Scene scene = load_scene(options.scene);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}\n", warning);
    if (!scene.picture)
        throw UsageError(fmt::format("{}: the scene has no [picture]", options.scene));
    if (options.size > 0) {
        std::size_t &width = scene.picture->width, &height = scene.picture->height;
        width = std::max<std::size_t>(1, (options.size * width + height / 2) / height);
        height = options.size;
    }
    std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
    if (files.empty()) files = {std::filesystem::path(options.scene).stem().concat(".png")};
    for (const auto& file : files) check_picture_name(file);
    const Table picture = make_picture(options.device.open(), *scene.picture, scene.materials);
    for (const auto& file : files) {
        write_picture(file, picture, scene.picture->exposure);
        fmt::print("{}\n", file.string());
    }
}

}  // namespace

void add_picture(CLI::App& app)
{
    CLI::App* verb =
        app.add_subcommand("picture", "Make the picture of a scene: meshes, lights and a camera");
    const auto options = std::make_shared<PictureOptions>();
    verb->add_option("SCENE", options->scene, "scene file (TOML) with a [picture]")->required();
    verb->add_option("-o,--output", options->files,
                     "file: .exr (linear radiance) or .png (sRGB; the scene's exposure); again for "
                     "more (default: SCENE.png)")
        ->allow_extra_args(false);
    verb->add_option("--size", options->size,
                     "height in pixels, in place of the scene's; the width follows")
        ->check(CLI::Range(1, 16384));
    options->device.add_to(*verb);
    verb->callback([options] { make(*options); });
}

}  // namespace gonio

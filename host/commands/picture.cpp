// SPDX-License-Identifier: Apache-2.0
// gonio picture SCENE.toml: the picture that a scene describes.
#include <fmt/format.h>

#include <algorithm>

#include "commands/commands.hpp"
#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "picture/picture_material.hpp"
#include "plan/interrupt.hpp"
#include "plan/progress.hpp"

namespace gonio {
namespace {

struct PictureOptions {
    DeviceOptions device;
    std::vector<std::string> scenes, files;
    std::string sheet;
    std::size_t size = 0;
};

/// Of the scene, at the size that is asked for.
PictureRequest request_of(const Scene& scene, const std::string& name, std::size_t size)
{
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}\n", warning);
    if (!scene.picture) throw UsageError(fmt::format("{}: the scene has no [picture]", name));
    PictureRequest picture = *scene.picture;
    if (size > 0) {
        const std::size_t height = picture.height;
        picture.width = std::max<std::size_t>(1, (size * picture.width + height / 2) / height);
        picture.height = size;
    }
    return picture;
}

/// Of one of the scenes.
std::vector<std::filesystem::path> files_of(const PictureOptions& options, const std::string& scene)
{
    std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
    if (files.empty() && options.sheet.empty())
        files.push_back(std::filesystem::path(scene).stem().concat(".png"));
    return files;
}

/// What there is to make.
struct Task {
    std::string scene;
    PictureRequest picture;
    std::vector<SceneMaterial> materials;
    double work = 0;
};

std::vector<Task> tasks_of(const PictureOptions& options)
{
    std::vector<Task> tasks;
    for (const std::string& name : options.scenes) {
        const Scene scene = load_scene(name);
        const PictureRequest picture = request_of(scene, name, options.size);
        tasks.push_back({name, picture, scene.materials, work_of(picture, scene.materials)});
    }
    return tasks;
}

/// With a line of progress; heeds Ctrl-C.
Table make_one(const Device& device, const Task& task, Progress& progress)
{
    double told = 0;
    std::string label;
    const auto after_each = [&](std::string_view doing, double amount) {
        throw_if_interrupted();
        if (label != doing) progress.begin(fmt::format("{}: {}", task.scene, label = doing));
        progress.advance(amount);
        told += amount;
    };
    Table picture = make_picture(device, task.picture, task.materials, after_each);
    progress.advance(task.work - told);  // what no ray has met is not done
    return picture;
}

void make(const PictureOptions& options)
{
    if (!options.files.empty() && options.scenes.size() > 1)
        throw UsageError("-o is for one scene; allowed for several is --sheet");
    for (const std::string& file : options.files) check_picture_name(file);
    const std::vector<Task> tasks = tasks_of(options);
    const Device device = options.device.open();
    catch_interrupts();
    double work = 0;
    for (const Task& task : tasks) work += task.work;
    Progress progress(work);
    std::vector<PictureCard> cards;
    for (const Task& task : tasks) {
        const Table picture = make_one(device, task, progress);
        for (const auto& file : files_of(options, task.scene)) {
            write_picture(file, picture, task.picture.exposure);
            fmt::print("{}\n", file.string());
        }
        if (!options.sheet.empty())
            cards.push_back({picture, task.picture.exposure, task.picture.title});
    }
    if (options.sheet.empty()) return;
    write_picture_sheet(options.sheet, cards);
    fmt::print("{}\n", options.sheet);
}

}  // namespace

void add_picture(CLI::App& app)
{
    CLI::App* verb =
        app.add_subcommand("picture", "Make the picture of a scene: meshes, lights and a camera");
    const auto options = std::make_shared<PictureOptions>();
    verb->add_option("SCENE", options->scenes, "scene file (TOML) with a [picture]; or several")
        ->required();
    verb->add_option("-o,--output", options->files,
                     "file: .exr (linear radiance) or .png (sRGB; the scene's exposure); again for "
                     "more (default: SCENE.png)")
        ->allow_extra_args(false);
    verb->add_option("--sheet", options->sheet,
                     "PNG with the pictures of all scenes side by side, titles below");
    verb->add_option("--size", options->size,
                     "height in pixels, in place of the scene's; the width follows")
        ->check(CLI::Range(1, 16384));
    options->device.add_to(*verb);
    verb->callback([options] { make(*options); });
}

}  // namespace gonio

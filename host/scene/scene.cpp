// SPDX-License-Identifier: Apache-2.0
// Reads scene files: the sections, and what must agree between them.
#include "gonio/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scene/document.hpp"
#include "scene/material.hpp"
#include "scene/picture.hpp"
#include "scene/table.hpp"

namespace gonio {
namespace {

/// Names are unique: the second of a name is refused at its place.
class Names {
public:
    explicit Names(std::string_view what) : what_(what) {}

    void add(const std::string& name, const Where& where)
    {
        const auto [earlier, is_new] = seen_.emplace(name, where);
        if (!is_new)
            throw UsageError(fmt::format("{}there is a {} `{}` already: {}", where, what_, name,
                                         earlier->second.substr(0, earlier->second.size() - 2)));
    }

private:
    std::string_view what_;
    std::map<std::string, Where> seen_;
};

std::vector<Value> list_of(const Section& root, std::string_view key)
{
    const auto value = root.find(key);
    return value ? value->list() : std::vector<Value>();
}

Storage read_output(const Section& root, std::filesystem::path& directory)
{
    Storage storage;
    if (const auto value = root.find("output")) {
        const Section output(*value);
        output.allow({"directory", "format", "precision", "compression"});
        if (const auto path = output.find("directory")) {
            if (path->text().empty()) path->fail("`directory` is empty");
            directory = path->text();
        }
        read_storage(output, storage);
    }
    return storage;
}

void warn_of_unused(Scene& scene)
{
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const bool used = std::ranges::count(scene.tables, m, &TableRequest::material) > 0 ||
                          (scene.picture && std::ranges::count(scene.picture->meshes, m,
                                                               &PictureMesh::material) > 0);
        if (!used)
            scene.warnings.push_back(fmt::format("{}nothing is asked of material `{}`",
                                                 scene.materials[m].where,
                                                 scene.materials[m].name));
    }
}

}  // namespace

Scene parse_scene(std::string_view text, std::string_view file)
{
    const toml::table document = parse_document(text, file);
    const Section root(Value(document, "the scene", document.source().begin));
    root.allow({"output", "material", "table", "picture"});
    Scene scene;
    const Storage storage = read_output(root, scene.directory);
    Names material_names("material"), table_names("table");
    for (const Value& value : list_of(root, "material")) {
        scene.materials.push_back(read_material(value));
        material_names.add(scene.materials.back().name, scene.materials.back().where);
    }
    for (const Value& value : list_of(root, "table")) {
        for (TableRequest& request : read_table_requests(value, scene.materials, storage)) {
            table_names.add(request.name, request.where);
            scene.tables.push_back(std::move(request));
        }
    }
    if (const auto picture = root.find("picture"))
        scene.picture =
            read_picture(*picture, scene.materials, std::filesystem::path(file).parent_path());
    if (scene.tables.empty() && !scene.picture)
        root.fail("the scene asks for no [[table]] and no [picture]");
    warn_of_unused(scene);
    return scene;
}

Scene load_scene(const std::filesystem::path& path)
{
    return parse_scene(read_document(path), path.string());
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// A scene: materials, the tables asked of them, and a picture. Everything in it is checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/layers.hpp"
#include "gonio/material.hpp"
#include "gonio/picture.hpp"
#include "gonio/quantity.hpp"
#include "gonio/skin.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// What messages about a part of a scene begin with: "file:line:column: ", empty if it came from no
/// file.
using Where = std::string;

/// A parameter that takes several values: as an axis of one table, or with a table for each.
struct Sweep {
    std::size_t part = 0;  ///< which lobe or layer it belongs to
    std::string parameter;
    std::vector<double> values;  ///< distinct; strictly monotonic if it is an axis
    bool axis = true;
    Where where;
};

/// A material of a scene. What it is made of holds the first value of every sweep.
struct SceneMaterial {
    std::string name;
    std::variant<std::vector<Lobe>, LayeredMedium, Skin> made_of;
    std::vector<Sweep> sweeps;  ///< those that are axes come from the outermost
    Where where;
    std::vector<double> ambient = {};  ///< as in Material
    std::optional<Lobe> surface = {};  ///< of layers and skin in pictures
};

/// No error is smaller: what rounding to double leaves in sums.
constexpr double least_error = 1e-14;

/// How exact, how long or how many: what is not set is not limited.
struct Budget {
    std::optional<double> max_error;  ///< of a table's largest value
    std::optional<double> seconds;
    std::optional<std::uint64_t> photons;
    std::optional<double> ring_error = {};  ///< as in ProfileRequest
};

/// How a table is stored.
struct Storage {
    std::string format = "exr";
    WriteOptions write;
};

/// A grid whose counts follow from how exact interpolation between its samples has to be.
struct GridFit {
    GridKind kind = GridKind::isotropic;
    Samples samples = Samples::centre;
    Spacing spacing = Spacing::linear;  ///< of a Rusinkiewicz grid
    double delta_phi_to = 360;          ///< of an isotropic one
    bool cubic = false;                 ///< how the table will be read; else linearly
};

struct TableRequest {
    std::string name;          ///< the stem of its file
    std::size_t material = 0;  ///< index into Scene::materials
    const Quantity* quantity = nullptr;
    std::optional<Grid> grid;  ///< set, or fit is, exactly if quantity->on_grid
    std::optional<GridFit> fit;
    std::vector<Axis> axes;  ///< else the quantity's, from the outermost
    std::string solver;      ///< one of quantity->solvers
    LightSource light;       ///< of layers
    std::uint64_t seed = 1;  ///< of the solver monte_carlo
    Budget budget;
    Storage storage;
    Where where;
};

struct Scene {
    std::filesystem::path directory = "tables";  ///< relative to where the program runs
    std::vector<SceneMaterial> materials;
    std::vector<TableRequest> tables;
    std::optional<PictureRequest> picture;
    std::vector<std::string> warnings;  ///< e.g. a material that nothing names
};

/// Reads and checks a scene. Throws UsageError that begins with file:line:column and says what is
/// wrong, what is allowed, and the nearest name.
Scene load_scene(const std::filesystem::path& path);

/// The same for a text; `file` is what messages call it.
Scene parse_scene(std::string_view text, std::string_view file);

}  // namespace gonio

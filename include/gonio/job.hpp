// SPDX-License-Identifier: Apache-2.0
// A job: one table to compute, with everything that determines its bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/material.hpp"
#include "gonio/scene.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// Light in layers: what a job computes that is not of a surface.
struct LightJob {
    LayeredMedium medium;
    const Quantity* quantity = nullptr;
    std::string solver;  ///< "adding_doubling" or "monte_carlo"
    LightSource light = {};
    std::uint64_t seed = 1;
    Budget budget = {};
};

struct Job {
    std::string name;  ///< the stem of its file
    std::vector<Material>
        materials;  ///< one per point of the swept axes, in row-major order; the same lobes in each
    Measure measure = Measure::brdf;
    Grid grid;
    std::optional<LightJob> layers;  ///< in place of materials, measure and grid
    TableHeader header;              ///< swept axes first, then those of the grid
    std::filesystem::path path;
    std::string format = "exr";
    WriteOptions write;
    Where where;  ///< of the table in its scene
};

/// The tables of a scene in its order, one job for each file. `directory` overrides the scene's
/// unless it is empty. Throws UsageError for what the parts of the scene allow and their
/// combination does not: an anisotropic material on a grid without a tangent frame, two files of
/// one name.
std::vector<Job> plan_jobs(const Scene& scene, const std::filesystem::path& directory = {});

/// A text that is the same for two jobs exactly if their files have the same bytes. It is the
/// header, which says all that determines them, the program's version included.
std::string definition(const Job& job);

}  // namespace gonio

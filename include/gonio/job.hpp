// SPDX-License-Identifier: Apache-2.0
// A job: one table to compute, with everything that determines its bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gonio/albedo.hpp"
#include "gonio/grid.hpp"
#include "gonio/material.hpp"
#include "gonio/profile.hpp"
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

/// A cell of a table of integrals over the hemisphere: of which of the job's materials, and where.
/// other_cosine: of the viewer, where a quantity has both directions.
struct IntegralCell {
    std::size_t material = 0;
    Incidence at;
    double other_cosine = 1;
};

struct Job {
    std::string name;  ///< the stem of its file
    std::vector<Material>
        materials;  ///< one per point of the swept axes, in row-major order; the same lobes in each
    Measure measure = Measure::brdf;
    Grid grid;
    std::optional<LightJob> layers;         ///< in place of materials, measure and grid
    std::optional<SkinTask> skin;           ///< in place of them all
    std::optional<ProfileRequest> profile;  ///< of the skin: its R(r) by photons
    std::vector<IntegralCell> cells;        ///< in place of the grid, in the order of the table
    double max_error = 1e-6;  ///< of an integral, or of interpolation on a grid that was fitted
    double interpolation_error = 0;  ///< that such a grid has
    bool must_reach = false;         ///< it is an error if the max_error asked for is not reached
    /// For the whole of an integral or of a fitted grid, s: as exact as that allows.
    std::optional<double> seconds;
    std::optional<GridFit> fit;  ///< of a grid that is chosen by time, when the table is made
    TableHeader header;          ///< swept axes first, then those of the grid or the cells
    std::filesystem::path path;
    std::string format = "exr";
    WriteOptions write;
    Where where;  ///< of the table in its scene
};

/// Are values rounded to 16 bits?
inline bool stores_half(const Job& job)
{
    return job.format == "exr" && job.write.half;
}

/// The tables of a scene in its order, one job for each file. `directory` overrides the scene's
/// unless it is empty. Throws UsageError for what the parts of the scene allow and their
/// combination does not: an anisotropic material on a grid without a tangent frame, two files of
/// one name.
std::vector<Job> plan_jobs(const Scene& scene, const std::filesystem::path& directory = {});

/// A text that is the same for two jobs exactly if their files have the same bytes. It is the
/// header, which says all that determines them, the program's version included.
std::string definition(const Job& job);

}  // namespace gonio

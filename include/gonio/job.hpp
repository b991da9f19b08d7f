// SPDX-License-Identifier: Apache-2.0
// A job: one table to compute, with everything that determines its bytes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gonio/grid.hpp"
#include "gonio/material.hpp"
#include "gonio/table.hpp"

namespace gonio {

struct Job {
    std::string name;  ///< the stem of its file
    std::vector<Material>
        materials;  ///< one per point of the swept axes, in row-major order; the same lobes in each
    Measure measure = Measure::brdf;
    Grid grid;
    TableHeader header;  ///< swept axes first, then those of the grid
    std::filesystem::path path;
    std::string format = "exr";
    WriteOptions write;
};

/// A text that is the same for two jobs exactly if their files have the same bytes: the program's
/// version and everything above but the path. A finished table is recognised by it.
std::string definition(const Job& job);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The specialised program of a material on a grid, and the parameters that it reads.
#pragma once

#include <string>
#include <vector>

#include "gonio/material.hpp"
#include "opencl/program.hpp"

namespace gonio {

/// What a table program is compiled for.
struct TableProgram {
    std::string grid_file;
    Measure measure = Measure::brdf;
    bool mirrored = false;    ///< columns symmetric about their middle
    bool reciprocal = false;  ///< rows (i, o) and (o, i) agree
    unsigned width = 1;
    bool special = false;  ///< not for other numbers: facets that reflect all, colours that agree
};

/// "NAME=VALUE" of all that kernel `table` is compiled for, besides lobes and choices.
std::vector<std::string> table_definitions(const Material& material, const TableProgram& program);

/// Builds kernel `table` for the lobes and choices of a material; their numbers stay arguments.
cl::Kernel table_kernel(Device::State& device, const Material& material,
                        const TableProgram& program);

/// Likewise of kernel `albedo`.
std::vector<std::string> albedo_definitions(const Material& material, bool isotropic);

/// Builds kernel `albedo`, for BRDFs, likewise; isotropic if all materials are that it is used for.
cl::Kernel albedo_kernel(Device::State& device, const Material& material, bool isotropic);

/// Builds kernel `sample` or `density` of sample.cl, for BRDFs, likewise.
cl::Kernel sampling_kernel(Device::State& device, const Material& material, const char* name);

/// Parameters and weight of each lobe, in the order in which core/material.cl reads them.
std::vector<float> parameter_values(const Material& material);

}  // namespace gonio

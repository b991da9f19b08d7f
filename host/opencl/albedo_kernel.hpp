// SPDX-License-Identifier: Apache-2.0
// The kernel that integrates one lobe over the hemisphere for many cells at once.
#pragma once

#include <vector>

#include "gonio/material.hpp"
#include "opencl/program.hpp"
#include "quadrature/nodes.hpp"

namespace gonio {

/// Cells of ascending materials, and the lines of nodes of each. All lines are divided by one rule.
struct AlbedoBatch {
    std::vector<AlbedoCell> cells;
    std::vector<std::vector<AzimuthNode>> lines;
    quadrature_map map = map_half;
    int order = 0;
};

class AlbedoKernel {
public:
    /// materials: the same lobes and options in each.
    AlbedoKernel(Device::State& device, const std::vector<Material>& materials, Fixed fixed);

    /// The integral of f cos of each cell: [channel][cell].
    std::vector<std::vector<double>> integrate(const AlbedoBatch& batch);

    double seconds() const { return seconds_; }

private:
    Device::State& device_;
    unsigned width_;
    std::size_t channels_;
    cl::Kernel kernel_;
    cl::Buffer parameters_;
    double seconds_ = 0;
};

}  // namespace gonio

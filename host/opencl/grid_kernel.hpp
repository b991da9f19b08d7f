// SPDX-License-Identifier: Apache-2.0
// One material on one grid, ready to run tile by tile.
#pragma once

#include "gonio/compute.hpp"
#include "grid/direction_tables.hpp"
#include "opencl/buffers.hpp"
#include "opencl/table_program.hpp"

namespace gonio {

/// The kernel with its tables on the device.
class GridKernel {
public:
    GridKernel(Device::State& device, const Material& material, const DirectionTables& tables,
               TableProgram program);

    /// Enqueues rows [first, first + count) into out: [channel][row][column].
    cl::Event enqueue(const OutputBuffer& out, std::size_t first, std::size_t count);

    const TableProgram& program() const { return program_; }
    double build_seconds() const { return build_seconds_; }

private:
    Device::State& device_;
    TableProgram program_;
    std::size_t length_;
    double build_seconds_ = 0;
    cl::Kernel kernel_;
    std::vector<cl::Buffer> inputs_;
};

/// The widest width not above the device's at which a row, or half of it, fills a vector.
unsigned fitting_width(unsigned width, std::size_t columns);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// One material on one grid, ready to run tile by tile.
#include "opencl/grid_kernel.hpp"

#include <algorithm>

#include "stopwatch.hpp"

namespace gonio {

unsigned fitting_width(unsigned width, std::size_t columns)
{
    while (width > 1 && width > columns) width /= 2;
    return width;
}

GridKernel::GridKernel(Device::State& device, const Material& material,
                       const DirectionTables& tables, TableProgram program)
    : device_(device), program_(std::move(program)), length_(tables.length)
{
    const std::size_t columns = program_.mirrored ? (length_ + 1) / 2 : length_;
    program_.grid_file = tables.grid_file;
    program_.width = fitting_width(program_.width, columns);
    const Stopwatch since;
    kernel_ = table_kernel(device, material, program_);
    build_seconds_ = since.seconds();

    inputs_.push_back(input_buffer(device, parameter_values(material)));
    kernel_.setArg(1, inputs_.back());
    kernel_.setArg(2, static_cast<cl_uint>(length_));
    cl_uint argument = 5;
    for (const std::vector<float>& table : tables.buffers) {
        inputs_.push_back(input_buffer(device, table));
        kernel_.setArg(argument++, inputs_.back());
    }
    for (const unsigned count : tables.counts)
        kernel_.setArg(argument++, static_cast<cl_uint>(count));
}

cl::Event GridKernel::enqueue(const OutputBuffer& out, std::size_t first, std::size_t count)
{
    kernel_.setArg(0, out.buffer());
    kernel_.setArg(3, static_cast<cl_ulong>(first));
    kernel_.setArg(4, static_cast<cl_ulong>(count));
    // A processor's core walks along rows; a graphics card's lanes share a row, so that their
    // stores fall side by side.
    const bool cpu = device_.info.type == "CPU";
    const std::size_t chunks =
        std::min<std::size_t>(count, std::size_t{device_.info.compute_units} * 32);
    const std::size_t vectors = (length_ + program_.width - 1) / program_.width;
    const std::size_t lanes = cpu && count > 1 ? 1 : std::min<std::size_t>(vectors, cpu ? 32 : 64);
    cl::Event event;
    device_.queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(lanes, chunks),
                                       cl::NDRange(cpu ? 1 : lanes, 1), nullptr, &event);
    return event;
}

}  // namespace gonio

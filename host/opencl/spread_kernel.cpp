// SPDX-License-Identifier: Apache-2.0
// Runs picture/spread.cl.
#include "opencl/spread_kernel.hpp"

#include <fmt/format.h>

#include "gonio/errors.hpp"
#include "opencl/buffers.hpp"
#include "opencl/grid_kernel.hpp"
#include "opencl/program.hpp"

namespace gonio {

struct SpreadKernel::State {
    Device::State& device;
    std::size_t width, height;
    cl::Kernel kernel;
    cl::Buffer places;
};

SpreadKernel::SpreadKernel(const Device& device, std::size_t width, std::size_t height,
                           const std::vector<float>& places)
try {
    const unsigned vector = fitting_width(device.width(), width);
    const cl::Program program = build_program(device.state(), "", "picture/spread.cl", {}, vector);
    state_ =
        std::make_unique<State>(State{device.state(), width, height, cl::Kernel(program, "spread"),
                                      input_buffer(device.state(), places)});
} catch (const cl::Error& error) {
    throw RunError(fmt::format("{} failed: {}", device.info().name, error_text(error)));
}

SpreadKernel::~SpreadKernel() = default;

std::vector<float> SpreadKernel::spread(const SpreadBlocks& blocks, double variance,
                                        unsigned radius)
try {
    auto& [device, width, height, kernel, places] = *state_;
    const std::size_t count = 3 * width * height;
    const cl::Buffer input = input_buffer(device, blocks.values);
    OutputBuffer out(device, count);
    cl_uint argument = 0;
    kernel.setArg(argument++, out.buffer());
    kernel.setArg(argument++, places);
    kernel.setArg(argument++, input);
    for (const std::size_t number : {width, height})
        kernel.setArg(argument++, static_cast<cl_uint>(number));
    for (const unsigned number : {blocks.columns, blocks.rows, blocks.stride, radius})
        kernel.setArg(argument++, number);
    kernel.setArg(argument, static_cast<float>(1 / (2 * variance)));
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(height));
    out.map(count);
    const float* values = out.wait();
    std::vector<float> result(values, values + count);
    out.unmap();
    out.check_canary();
    return result;
} catch (const cl::Error& error) {
    throw RunError(fmt::format("{} failed: {}", state_->device.info.name, error_text(error)));
}

}  // namespace gonio

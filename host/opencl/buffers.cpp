// SPDX-License-Identifier: Apache-2.0
// Device buffers: inputs, and outputs that are mapped and guarded by a canary.
#include "opencl/buffers.hpp"

#include <algorithm>
#include <array>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

/// As long as the widest vector: a store that misses the end by one vector hits it.
constexpr std::array<float, 16> canary = {-1.5e9F, 2.5e-7F, -3.5e9F, 4.5e-7F, -5.5e9F, 6.5e-7F,
                                          -7.5e9F, 8.5e-7F, -9.5e9F, 1.5e-7F, -2.5e9F, 3.5e-7F,
                                          -4.5e9F, 5.5e-7F, -6.5e9F, 7.5e-7F};

}  // namespace

cl::Buffer input_buffer(Device::State& device, const std::vector<float>& values)
{
    cl::Buffer buffer(device.context, CL_MEM_READ_ONLY, values.size() * sizeof(float));
    device.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(float),
                                    values.data());
    return buffer;
}

OutputBuffer::OutputBuffer(Device::State& device, std::size_t size) : device_(device), size_(size)
{
    const std::size_t bytes = (size + canary.size()) * sizeof(float);
    const auto spare = std::ranges::find_if(device.spare_outputs, [&](const cl::Buffer& buffer) {
        return buffer.getInfo<CL_MEM_SIZE>() >= bytes;
    });
    if (spare != device.spare_outputs.end()) {
        buffer_ = *spare;
        device.spare_outputs.erase(spare);
    } else {
        device.spare_outputs.clear();
        buffer_ = cl::Buffer(device.context, CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR, bytes);
    }
    device_.queue.enqueueWriteBuffer(buffer_, CL_TRUE, size * sizeof(float), sizeof canary,
                                     canary.data());
}

OutputBuffer::~OutputBuffer()
{
    device_.spare_outputs.push_back(buffer_);
}

void OutputBuffer::map(std::size_t count, cl_map_flags flags)
{
    values_ = static_cast<float*>(device_.queue.enqueueMapBuffer(
        buffer_, CL_FALSE, flags, 0, count * sizeof(float), nullptr, &mapped_));
    device_.queue.flush();
}

float* OutputBuffer::wait()
{
    mapped_.wait();
    return values_;
}

void OutputBuffer::unmap()
{
    device_.queue.enqueueUnmapMemObject(buffer_, values_);
}

void OutputBuffer::check_canary()
{
    std::array<float, canary.size()> behind{};
    device_.queue.enqueueReadBuffer(buffer_, CL_TRUE, size_ * sizeof(float), sizeof canary,
                                    behind.data());
    if (behind != canary)
        throw RunError(
            "a kernel wrote behind the end of its output: this is a fault of gonio or of the "
            "driver");
}

}  // namespace gonio

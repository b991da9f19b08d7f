// SPDX-License-Identifier: Apache-2.0
// Device buffers: inputs, and outputs that are mapped (no copy on a CPU device) and guarded by a
// canary.
#pragma once

#include <cstddef>
#include <vector>

#include "opencl/state.hpp"

namespace gonio {

/// A read-only buffer filled from the host.
cl::Buffer input_buffer(Device::State& device, const std::vector<float>& values);

/// An output of `size` floats with a canary behind it. Its memory is taken from an earlier one of
/// the device if that was large enough, and left to the next.
class OutputBuffer {
public:
    OutputBuffer(Device::State& device, std::size_t size);
    ~OutputBuffer();
    OutputBuffer(const OutputBuffer&) = delete;
    OutputBuffer& operator=(const OutputBuffer&) = delete;

    const cl::Buffer& buffer() const { return buffer_; }

    /// Enqueues the mapping of the first `count` floats; finish with wait().
    void map(std::size_t count, cl_map_flags flags = CL_MAP_READ);
    /// Waits for the mapping.
    float* wait();
    void unmap();
    /// Throws RunError if a kernel has written behind the end.
    void check_canary();

private:
    Device::State& device_;
    std::size_t size_;
    cl::Buffer buffer_;
    cl::Event mapped_;
    float* values_ = nullptr;
};

}  // namespace gonio

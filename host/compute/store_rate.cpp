// SPDX-License-Identifier: Apache-2.0
// The roof of every table: how fast the device writes floats when it computes nothing.
#include "compute/store_rate.hpp"

#include <algorithm>
#include <array>

#include "opencl/buffers.hpp"
#include "opencl/program.hpp"

namespace gonio {
namespace {

double measure(Device::State& device)
{
    constexpr std::size_t count = std::size_t{16} << 20;
    cl::Kernel kernel(build_program(device, "", "store.cl", {}, device.width), "store_only");
    OutputBuffer out(device, count);
    kernel.setArg(0, out.buffer());
    kernel.setArg(1, static_cast<cl_ulong>(count));
    // A graphics card wants many short blocks, a processor's core a few long ones.
    const std::size_t items =
        device.info.type == "CPU" ? std::size_t{device.info.compute_units} * 32 : count / 64;
    std::array<double, 5> seconds{};
    for (std::size_t run = 0; run <= seconds.size(); ++run) {
        cl::Event event;
        device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NullRange,
                                          nullptr, &event);
        event.wait();
        // The first run touches the pages of the buffer and does not count.
        if (run > 0) seconds[run - 1] = seconds_of(event);
    }
    std::ranges::nth_element(seconds, seconds.begin() + seconds.size() / 2);
    return static_cast<double>(count) / seconds[seconds.size() / 2];
}

}  // namespace

double stored_values_per_second(const Device& device)
{
    Device::State& state = device.state();
    if (state.stored_per_second == 0) state.stored_per_second = measure(state);
    return state.stored_per_second;
}

}  // namespace gonio

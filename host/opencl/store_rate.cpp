// SPDX-License-Identifier: Apache-2.0
// The roof of every table: how fast the device writes floats when it computes nothing.
#include "opencl/store_rate.hpp"

#include <algorithm>
#include <array>

#include "opencl/program.hpp"

namespace gonio {

StoreRate::StoreRate(Device::State& device)
    : device_(device),
      kernel_(build_program(device, "", "store.cl", {}, device.width), "store_only"),
      out_(device, count)
{
    kernel_.setArg(0, out_.buffer());
    kernel_.setArg(1, static_cast<cl_ulong>(count));
    seconds();  // touches the pages of the buffer
}

double StoreRate::seconds()
{
    // A graphics card wants many short blocks, a processor's core a few long ones.
    const bool cpu = device_.info.type == "CPU";
    const std::size_t items = cpu ? std::size_t{device_.info.compute_units} * 32 : count / 64;
    cl::Event event;
    device_.queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(items), cl::NullRange,
                                       nullptr, &event);
    event.wait();
    return seconds_of(event);
}

double stored_values_per_second(const Device& device)
{
    Device::State& state = device.state();
    if (state.stored_per_second == 0) {
        StoreRate rate(state);
        std::array<double, 3> runs{};
        for (double& run : runs) run = rate.seconds();
        std::ranges::sort(runs);
        state.stored_per_second = static_cast<double>(StoreRate::count) / runs[runs.size() / 2];
    }
    return state.stored_per_second;
}

}  // namespace gonio

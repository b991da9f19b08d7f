// SPDX-License-Identifier: Apache-2.0
// A part of a device by OpenCL's device fission.
#include "opencl/fission.hpp"

#include <array>

#include "opencl/state.hpp"

namespace gonio {

std::optional<Device> part_of(const Device& device, unsigned compute_units)
{
    const std::array<cl_device_partition_property, 4> by_counts{
        CL_DEVICE_PARTITION_BY_COUNTS, static_cast<cl_device_partition_property>(compute_units),
        CL_DEVICE_PARTITION_BY_COUNTS_LIST_END, 0};
    try {
        std::vector<cl::Device> parts;
        device.state().device.createSubDevices(by_counts.data(), &parts);
        auto state = std::make_shared<Device::State>();
        state->info = device.info();
        state->info.compute_units = compute_units;
        state->width = device.width();
        state->device = parts.at(0);
        state->context = cl::Context(state->device);
        state->queue = cl::CommandQueue(state->context, state->device, CL_QUEUE_PROFILING_ENABLE);
        return Device(std::move(state));
    } catch (const cl::Error&) {
        return std::nullopt;
    }
}

}  // namespace gonio

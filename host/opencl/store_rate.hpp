// SPDX-License-Identifier: Apache-2.0
// The roof of every table: how fast the device writes floats when it computes nothing.
#pragma once

#include <cstddef>

#include "opencl/buffers.hpp"

namespace gonio {

/// Kernel `store` on a buffer of 64 MiB.
class StoreRate {
public:
    static constexpr std::size_t count = std::size_t{16} << 20;  ///< floats it writes

    explicit StoreRate(Device::State& device);

    /// Of one run, by the device's clock.
    double seconds();

private:
    Device::State& device_;
    cl::Kernel kernel_;
    OutputBuffer out_;
};

/// Floats per second: the median of a few runs, measured once per device.
double stored_values_per_second(const Device& device);

}  // namespace gonio

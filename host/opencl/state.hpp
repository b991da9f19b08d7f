// SPDX-License-Identifier: Apache-2.0
// What an opened device holds, for the code that talks to OpenCL.
#pragma once

#include <CL/opencl.hpp>
#include <map>
#include <string>
#include <vector>

#include "gonio/device.hpp"

namespace gonio {

struct Device::State {
    DeviceInfo info;
    unsigned width = 1;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;                       ///< in order, with profiling
    std::map<std::string, cl::Program> programs;  ///< by options and source
    std::vector<cl::Buffer>
        spare_outputs;             ///< of finished tables: their pages need not be touched again
    double stored_per_second = 0;  ///< see opencl/store_rate.hpp; 0 until measured
};

/// Seconds that a finished command took by the device's clock.
double seconds_of(const cl::Event& event);

/// Text of an OpenCL status, e.g. "CL_OUT_OF_RESOURCES (-5)".
std::string error_text(const cl::Error& error);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// OpenCL devices: what there is, and the one that is used.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

/// A device as clinfo numbers it.
struct DeviceInfo {
    unsigned platform = 0, device = 0;
    std::string name, platform_name, vendor, driver, version;
    std::string type;  ///< "CPU", "GPU" or "accelerator"
    unsigned compute_units = 0;
    unsigned clock_mhz = 0;
    unsigned native_width = 1;  ///< native vector width for float
    std::uint64_t global_bytes = 0, largest_buffer_bytes = 0;
    bool correctly_rounded = false;  ///< can round divisions and square roots correctly
    bool subnormals = false;
    bool long_atomics = false;  ///< has 64-bit integer atomics
};

/// All devices of all platforms; empty where there is no OpenCL.
std::vector<DeviceInfo> list_devices();

/// An opened device: context, queue and the programs built on it. Copies share them.
class Device {
public:
    /// selector: "P:D" as clinfo numbers them, or a part of the name, which must fit one device
    /// only; empty: the environment variable GONIO_DEVICE, else the first CPU device, else the
    /// first device. width: vector width of the kernels (1, 2, 4, 8, 16), 0 to choose by device.
    /// Throws NoDevice, UsageError.
    explicit Device(const std::string& selector = "", unsigned width = 0);

    const DeviceInfo& info() const;
    unsigned width() const;

    struct State;
    explicit Device(std::shared_ptr<State> state) : state_(std::move(state)) {}
    State& state() const { return *state_; }

private:
    std::shared_ptr<State> state_;
};

}  // namespace gonio

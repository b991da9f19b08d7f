// SPDX-License-Identifier: Apache-2.0
// The options that choose a device and a vector width.
#include "commands/commands.hpp"

namespace gonio {

void DeviceOptions::add_to(CLI::App& verb)
{
    verb.add_option("-d,--device", device,
                    "OpenCL device: P:D as clinfo numbers them, or a part of the name (default: "
                    "GONIO_DEVICE, else the "
                    "processor)");
    verb.add_option("--width", width,
                    "vector width of the kernels: 1, 2, 4, 8 or 16 (default: by device)");
}

Device DeviceOptions::open() const
{
    return Device(device, width);
}

}  // namespace gonio

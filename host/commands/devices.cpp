// SPDX-License-Identifier: Apache-2.0
// gonio devices: what OpenCL offers here.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "gonio/errors.hpp"

namespace gonio {
namespace {

nlohmann::ordered_json json_of(const DeviceInfo& info)
{
    return {{"id", fmt::format("{}:{}", info.platform, info.device)},
            {"name", info.name},
            {"type", info.type},
            {"platform", info.platform_name},
            {"vendor", info.vendor},
            {"driver", info.driver},
            {"version", info.version},
            {"compute_units", info.compute_units},
            {"clock_mhz", info.clock_mhz},
            {"global_bytes", info.global_bytes},
            {"largest_buffer_bytes", info.largest_buffer_bytes},
            {"native_width", info.native_width},
            {"correctly_rounded", info.correctly_rounded},
            {"subnormals", info.subnormals},
            {"long_atomics", info.long_atomics}};
}

void print(const DeviceInfo& info)
{
    fmt::print("{}:{}  {}\n", info.platform, info.device, info.name);
    fmt::print("     {}, {} compute units at {} MHz, native width {}\n", info.type,
               info.compute_units, info.clock_mhz, info.native_width);
    fmt::print("     {}, driver {}, {}\n", info.platform_name, info.driver, info.version);
    fmt::print("     {:.1f} GiB memory, largest buffer {:.1f} GiB\n",
               static_cast<double>(info.global_bytes) / (1 << 30),
               static_cast<double>(info.largest_buffer_bytes) / (1 << 30));
}

void list(bool json)
{
    const std::vector<DeviceInfo> all = list_devices();
    if (json) {
        nlohmann::ordered_json array = nlohmann::ordered_json::array();
        for (const DeviceInfo& info : all) array.push_back(json_of(info));
        fmt::print("{}\n", nlohmann::ordered_json{{"devices", array}}.dump(2));
        return;
    }
    if (all.empty())
        fmt::print(
            "There is no OpenCL device. For the processor itself:\n  apt-get install "
            "pocl-opencl-icd\n"
            "For graphics cards: intel-opencl-icd, mesa-opencl-icd or nvidia-opencl-icd.\n");
    for (const DeviceInfo& info : all) print(info);
}

}  // namespace

void add_devices(CLI::App& app)
{
    CLI::App* verb =
        app.add_subcommand("devices", "List the OpenCL devices, numbered as clinfo numbers them");
    const auto json = std::make_shared<bool>(false);
    verb->add_flag("--json", *json, "Print JSON");
    verb->callback([json] { list(*json); });
}

}  // namespace gonio

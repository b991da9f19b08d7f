// SPDX-License-Identifier: Apache-2.0
// Lists and chooses OpenCL devices. A device is never changed silently: what does not fit is an
// error.
#include "gonio/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "gonio/errors.hpp"
#include "opencl/state.hpp"

namespace gonio {
namespace {

constexpr const char* install_hint =
    "install a driver, e.g. `apt-get install pocl-opencl-icd` for the processor itself "
    "(intel-opencl-icd, "
    "nvidia-opencl-icd or mesa-opencl-icd for graphics cards)";

std::vector<cl::Platform> platforms()
{
    std::vector<cl::Platform> all;
    try {
        cl::Platform::get(&all);
    } catch (const cl::Error&) {
        all.clear();  // The loader reports "no platform" as an error.
    }
    return all;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform)
{
    std::vector<cl::Device> all;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &all);
    } catch (const cl::Error&) {
        all.clear();
    }
    return all;
}

std::string type_name(cl_device_type type)
{
    if (type & CL_DEVICE_TYPE_CPU) return "CPU";
    return type & CL_DEVICE_TYPE_GPU ? "GPU" : "accelerator";
}

std::string trimmed(std::string text)
{
    const auto visible = [](char c) { return c != ' ' && c != '\0'; };
    text.erase(std::find_if(text.rbegin(), text.rend(), visible).base(), text.end());
    text.erase(text.begin(), std::ranges::find_if(text, visible));
    return text;
}

DeviceInfo describe(const cl::Platform& platform, const cl::Device& device)
{
    DeviceInfo info;
    info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
    info.platform_name = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
    info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
    info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
    info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
    info.type = type_name(device.getInfo<CL_DEVICE_TYPE>());
    info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    info.clock_mhz = device.getInfo<CL_DEVICE_MAX_CLOCK_FREQUENCY>();
    info.native_width = device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
    info.global_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.largest_buffer_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    const cl_device_fp_config config = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    info.correctly_rounded = (config & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    info.subnormals = (config & CL_FP_DENORM) != 0;
    const std::string extensions = device.getInfo<CL_DEVICE_EXTENSIONS>();
    info.long_atomics = extensions.find("cl_khr_int64_base_atomics") != std::string::npos;
    return info;
}

std::string listing(const std::vector<DeviceInfo>& all)
{
    std::string text;
    for (const DeviceInfo& info : all)
        text += fmt::format("\n  {}:{}  {} ({})", info.platform, info.device, info.name,
                            info.platform_name);
    return text;
}

bool parse_numbers(const std::string& selector, unsigned& platform, unsigned& device)
{
    const char* const end = selector.data() + selector.size();
    const auto first = std::from_chars(selector.data(), end, platform);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != ':') return false;
    const auto second = std::from_chars(first.ptr + 1, end, device);
    return second.ec == std::errc() && second.ptr == end;
}

DeviceInfo choose_device(std::string selector)
{
    const std::vector<DeviceInfo> all = list_devices();
    if (all.empty()) throw NoDevice(fmt::format("there is no OpenCL device; {}", install_hint));
    if (selector.empty())
        if (const char* variable = std::getenv("GONIO_DEVICE")) selector = variable;
    if (selector.empty()) {
        const auto cpu = std::ranges::find(all, "CPU", &DeviceInfo::type);
        return cpu == all.end() ? all.front() : *cpu;
    }
    unsigned platform = 0, device = 0;
    const bool numbers = parse_numbers(selector, platform, device);
    std::vector<DeviceInfo> fitting;
    for (const DeviceInfo& info : all) {
        const auto holds_selector = [&](const std::string& name) {
            const auto equal = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
            return std::search(name.begin(), name.end(), selector.begin(), selector.end(), equal) !=
                   name.end();
        };
        const bool named = holds_selector(info.name) || holds_selector(info.platform_name);
        if (numbers ? info.platform == platform && info.device == device : named)
            fitting.push_back(info);
    }
    if (fitting.size() == 1) return fitting.front();
    if (fitting.empty())
        throw NoDevice(
            fmt::format("there is no device `{}`; there are:{}", selector, listing(all)));
    throw NoDevice(fmt::format("`{}` fits several devices; choose one by number:{}", selector,
                               listing(fitting)));
}

unsigned default_width(const DeviceInfo& info)
{
    if (info.type != "CPU") return 1;
    return std::clamp(info.native_width, 1U, 16U);
}

}  // namespace

std::vector<DeviceInfo> list_devices()
{
    std::vector<DeviceInfo> all;
    unsigned p = 0;
    for (const cl::Platform& platform : platforms()) {
        unsigned d = 0;
        for (const cl::Device& device : devices_of(platform)) {
            all.push_back(describe(platform, device));
            all.back().platform = p;
            all.back().device = d++;
        }
        ++p;
    }
    return all;
}

Device::Device(const std::string& selector, unsigned width) : state_(std::make_shared<State>())
{
    if (width != 0 && width != 1 && width != 2 && width != 4 && width != 8 && width != 16)
        throw UsageError(fmt::format("width is {}; allowed is 1, 2, 4, 8 or 16", width));
    state_->info = choose_device(selector);
    state_->width = width == 0 ? default_width(state_->info) : width;
    try {
        state_->device = devices_of(platforms().at(state_->info.platform)).at(state_->info.device);
        state_->context = cl::Context(state_->device);
        state_->queue =
            cl::CommandQueue(state_->context, state_->device, CL_QUEUE_PROFILING_ENABLE);
    } catch (const cl::Error& error) {
        throw RunError(
            fmt::format("device {} does not open: {}", state_->info.name, error_text(error)));
    }
}

const DeviceInfo& Device::info() const
{
    return state_->info;
}
unsigned Device::width() const
{
    return state_->width;
}

double seconds_of(const cl::Event& event)
{
    return 1e-9 * static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                      event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
}

std::string error_text(const cl::Error& error)
{
    return fmt::format("{} ({})", error.what(), error.err());
}

}  // namespace gonio

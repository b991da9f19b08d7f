// SPDX-License-Identifier: Apache-2.0
// Runs expressions of the kernels' language over lists of numbers, at any vector width.
#include "kernels/kernel_fixtures.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "opencl/buffers.hpp"
#include "opencl/program.hpp"

namespace gonio {

struct DeviceFunctions::State {
    Device device;
    cl::Kernel kernel;
    unsigned width;
};

DeviceFunctions::DeviceFunctions(const std::string& include,
                                 const std::vector<std::string>& expressions, unsigned width)
    : state_(new State{Device(), {}, width})
{
    std::string cases;
    for (std::size_t k = 0; k < expressions.size(); ++k)
        cases += fmt::format("    if (which == {}) store({}, out + at);\n", k, expressions[k]);
    const std::string text = fmt::format(R"(#include "core/real.cl"
#include "{}"
kernel void apply(global float *out, global const float *xs, global const float *ys,
                  const uint which)
{{
    const size_t at = get_global_id(0) * WIDTH;
    const real x = load(xs + at);
    const real y = load(ys + at);
{}}}
)",
                                         include, cases);
    state_->kernel =
        cl::Kernel(build_program(state_->device.state(), text, include, {}, width), "apply");
}

DeviceFunctions::~DeviceFunctions() = default;
DeviceFunctions::DeviceFunctions(DeviceFunctions&&) noexcept = default;

std::vector<float> DeviceFunctions::operator()(std::size_t expression, const std::vector<float>& x,
                                               const std::vector<float>& y)
{
    Device::State& state = state_->device.state();
    const cl::Buffer xs = input_buffer(state, x), ys = input_buffer(state, y);
    OutputBuffer out(state, x.size());
    state_->kernel.setArg(0, out.buffer());
    state_->kernel.setArg(1, xs);
    state_->kernel.setArg(2, ys);
    state_->kernel.setArg(3, static_cast<cl_uint>(expression));
    state.queue.enqueueNDRangeKernel(state_->kernel, cl::NullRange,
                                     cl::NDRange(x.size() / state_->width));
    out.map(x.size());
    const float* values = out.wait();
    std::vector<float> result(values, values + x.size());
    out.unmap();
    out.check_canary();
    return result;
}

std::vector<float> on_device(const std::string& include, const std::string& expression,
                             const std::vector<float>& x, const std::vector<float>& y,
                             unsigned width)
{
    return DeviceFunctions(include, {expression}, width)(0, x, y);
}

std::vector<float> floats_between(float from, float to, std::size_t count)
{
    const double first = std::bit_cast<std::int32_t>(from), last = std::bit_cast<std::int32_t>(to);
    std::vector<float> floats;
    for (std::size_t k = 0; k < count; ++k)
        floats.push_back(std::bit_cast<float>(static_cast<std::int32_t>(
            first + (last - first) * static_cast<double>(k) / static_cast<double>(count - 1))));
    return floats;
}

double ulps(float got, double exact)
{
    const double place = std::ldexp(1.0, std::ilogb(exact) - 23);
    return std::abs(static_cast<double>(got) - exact) / place;
}

}  // namespace gonio

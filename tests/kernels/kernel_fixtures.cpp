// SPDX-License-Identifier: Apache-2.0
// Runs one expression of the kernels' language over lists of numbers, at any vector width.
#include "kernels/kernel_fixtures.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "opencl/buffers.hpp"
#include "opencl/program.hpp"

namespace gonio {

std::vector<float> on_device(const std::string& include, const std::string& expression,
                             const std::vector<float>& x, const std::vector<float>& y,
                             unsigned width)
{
    const Device device;
    Device::State& state = device.state();
    const std::string text = fmt::format(R"(#include "core/real.cl"
#include "{}"
kernel void apply(global float *out, global const float *xs, global const float *ys)
{{
    const size_t at = get_global_id(0) * WIDTH;
    const real x = load(xs + at);
    const real y = load(ys + at);
    store({}, out + at);
}}
)",
                                         include, expression);
    cl::Kernel kernel(build_program(state, text, include, {}, width), "apply");
    const cl::Buffer xs = input_buffer(state, x), ys = input_buffer(state, y);
    OutputBuffer out(state, x.size());
    kernel.setArg(0, out.buffer());
    kernel.setArg(1, xs);
    kernel.setArg(2, ys);
    state.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(x.size() / width));
    out.map(x.size());
    const float* values = out.wait();
    std::vector<float> result(values, values + x.size());
    out.unmap();
    out.check_canary();
    return result;
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

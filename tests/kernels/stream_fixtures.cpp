// SPDX-License-Identifier: Apache-2.0
// Words of the kernels' random numbers, and Philox to check them by.
#include "stream_fixtures.hpp"

#include "opencl/program.hpp"

namespace gonio::test {

std::vector<SixWords> drawn(const std::string& preamble, const std::string& body,
                            std::uint64_t first, std::uint32_t count, std::uint64_t seed,
                            unsigned width)
{
    const Device device;
    Device::State& state = device.state();
    const std::string text = preamble + R"(#include "core/random.cl"
kernel void draw(global uint *out, const ulong first, const ulong seed)
{
    uint lanes[6][WIDTH], offsets[WIDTH];
    const uint at = (uint)get_global_id(0) * WIDTH;
    for (uint i = 0; i < WIDTH; ++i) offsets[i] = at + i;
    stream s = numbered_stream(first, load_words(offsets), seed);
)" + body + R"(
    for (uint i = 0; i < WIDTH; ++i)
        for (uint k = 0; k < 6; ++k) out[(at + i) * 6 + k] = lanes[k][i];
}
)";
    cl::Kernel kernel(build_program(state, text, "core/random.cl", {}, width), "draw");
    std::vector<SixWords> result(count);
    const cl::Buffer out(state.context, CL_MEM_WRITE_ONLY, count * sizeof result[0]);
    kernel.setArg(0, out);
    kernel.setArg(1, static_cast<cl_ulong>(first));
    kernel.setArg(2, static_cast<cl_ulong>(seed));
    state.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count / width));
    state.queue.enqueueReadBuffer(out, CL_TRUE, 0, count * sizeof result[0], result.data());
    return result;
}

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key, int rounds)
{
    for (int round = 0; round < rounds; ++round) {
        const std::uint64_t left = 0xD2511F53ULL * counter[0], right = 0xCD9E8D57ULL * counter[2];
        counter = {static_cast<std::uint32_t>(right >> 32) ^ counter[1] ^ key[0],
                   static_cast<std::uint32_t>(right),
                   static_cast<std::uint32_t>(left >> 32) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(left)};
        key[0] += 0x9E3779B9U;
        key[1] += 0xBB67AE85U;
    }
    return counter;
}

}  // namespace gonio::test

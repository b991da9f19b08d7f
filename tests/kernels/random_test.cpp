// SPDX-License-Identifier: Apache-2.0
// Random numbers of photons and samples: published answers, 64-bit numbers, every uniform.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "opencl/program.hpp"

namespace gonio::test {
namespace {

/// One word of each photon's stream behind its seed: words[0] is a, as the seed left it; words[4]
/// the first that xoshiro128++ gives.
std::vector<std::array<std::uint32_t, 6>> streams(std::uint64_t first, std::uint32_t count,
                                                  std::uint64_t seed, unsigned width)
{
    const Device device;
    Device::State& state = device.state();
    const std::string text = R"(#include "core/random.cl"
kernel void draw(global uint *out, const ulong first, const ulong seed)
{
    uint lanes[6][WIDTH], offsets[WIDTH];
    const uint at = (uint)get_global_id(0) * WIDTH;
    for (uint i = 0; i < WIDTH; ++i) offsets[i] = at + i;
    stream s = numbered_stream(first, load_words(offsets), seed);
    store_words(s.a, lanes[0]);
    store_words(s.b, lanes[1]);
    store_words(s.c, lanes[2]);
    store_words(s.d, lanes[3]);
    store_words(next_word(&s), lanes[4]);
    store_words(next_word(&s), lanes[5]);
    for (uint i = 0; i < WIDTH; ++i)
        for (uint k = 0; k < 6; ++k) out[(at + i) * 6 + k] = lanes[k][i];
}
)";
    cl::Kernel kernel(build_program(state, text, "core/random.cl", {}, width), "draw");
    std::vector<std::array<std::uint32_t, 6>> result(count);
    const cl::Buffer out(state.context, CL_MEM_WRITE_ONLY, count * sizeof result[0]);
    kernel.setArg(0, out);
    kernel.setArg(1, static_cast<cl_ulong>(first));
    kernel.setArg(2, static_cast<cl_ulong>(seed));
    state.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count / width));
    state.queue.enqueueReadBuffer(out, CL_TRUE, 0, count * sizeof result[0], result.data());
    return result;
}

/// Salmon et al., SC 2011, in 64-bit arithmetic.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key)
{
    for (int round = 0; round < 10; ++round) {
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

/// The known answers of Random123's kat_vectors for philox4x32 with 10 rounds.
TEST(RandomNumbers, ReferenceGivesThePublishedAnswers)
{
    using Block = std::array<std::uint32_t, 4>;
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
              (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
              (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomNumbers, SeedsEveryPhotonByItsNumber)
{
    constexpr std::uint64_t seed = 0x0123456789abcdef;
    // 10^12, and across the end of the lower 32 bits
    for (const std::uint64_t first :
         {std::uint64_t{0}, std::uint64_t{1'000'000'000'000}, (std::uint64_t{5} << 32) - 24}) {
        const auto narrow = streams(first, 64, seed, 1);
        for (std::uint32_t k = 0; k < 64; ++k) {
            const std::uint64_t number = first + k;
            const auto block =
                philox({static_cast<std::uint32_t>(number),
                        static_cast<std::uint32_t>(number >> 32), 0, 0},
                       {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
            for (std::size_t w = 0; w < 4; ++w) EXPECT_EQ(narrow[k][w], block[w]);
            // The first word of xoshiro128++ from its state, rotl(a + d, 7) + a.
            const std::uint32_t sum = block[0] + block[3];
            EXPECT_EQ(narrow[k][4], ((sum << 7) | (sum >> 25)) + block[0]);
        }
        EXPECT_EQ(streams(first, 64, seed, 16), narrow);
    }
}

/// xoshiro128++ 1.0, Blackman and Vigna: the second word of a state, by their code's steps.
TEST(RandomNumbers, StepsAsPublished)
{
    const auto rotl = [](std::uint32_t x, int k) { return (x << k) | (x >> (32 - k)); };
    for (const auto& words : streams(42, 16, 1, 16)) {
        std::array<std::uint32_t, 4> s{words[0], words[1], words[2], words[3]};
        const std::uint32_t t = s[1] << 9;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = rotl(s[3], 11);
        EXPECT_EQ(words[5], rotl(s[0] + s[3], 7) + s[0]);
    }
}

TEST(RandomNumbers, UniformsAreNeverZeroOrOne)
{
    // ((bits >> 8) | 1) 2^-24 for all bits: odd numbers below 2^24 are exact in float.
    for (std::uint32_t k = 1; k < (1U << 24); k += 2) {
        const float uniform = static_cast<float>(k) * 0x1p-24F;
        ASSERT_GT(uniform, 0.0F);
        ASSERT_LT(uniform, 1.0F);
        ASSERT_EQ(static_cast<double>(uniform), k * 0x1p-24);
    }
}

}  // namespace
}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// Random numbers of photons and samples: published answers, 64-bit numbers, every uniform.
#include <gtest/gtest.h>

#include "stream_fixtures.hpp"

namespace gonio::test {
namespace {

/// Of the engine's stream: [0] is a, as the seed left it; [4] the first word of xoshiro128++.
std::vector<SixWords> streams(std::uint64_t first, std::uint32_t count, std::uint64_t seed,
                              unsigned width)
{
    return drawn("", R"(
    store_words(s.a, lanes[0]);
    store_words(s.b, lanes[1]);
    store_words(s.c, lanes[2]);
    store_words(s.d, lanes[3]);
    store_words(next_word(&s), lanes[4]);
    store_words(next_word(&s), lanes[5]);
)",
                 first, count, seed, width);
}

/// The known answers of Random123's kat_vectors for philox4x32 with 10 rounds and with 7.
TEST(RandomNumbers, ReferenceGivesThePublishedAnswers)
{
    using Block = std::array<std::uint32_t, 4>;
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
              (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
              (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}, 7),
              (Block{0x5f6fb709, 0x0d893f64, 0x4f121f81, 0x4f730a48}));
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

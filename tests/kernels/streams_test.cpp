// SPDX-License-Identifier: Apache-2.0
// The streams that are compared with the engine's.
#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <utility>

#include "stream_fixtures.hpp"

namespace gonio::test {
namespace {

/// What two steps of a photon take.
std::vector<SixWords> steps(const std::string& preamble, std::uint64_t first, std::uint32_t count,
                            std::uint64_t seed)
{
    return drawn(preamble, R"(
    for (uint k = 0; k < 6; k += 3) {
        word words[3];
        next_three(&s, words, words + 1, words + 2);
        for (uint n = 0; n < 3; ++n) store_words(words[n], lanes[k + n]);
    }
)",
                 first, count, seed, 8);
}

/// By the words that their authors' codes give in 64-bit arithmetic.
TEST(ComparedStreams, StepAsPublished)
{
    using State = std::array<std::uint32_t, 4>;
    constexpr std::uint64_t seed = 0x0123456789abcdef, first = (std::uint64_t{5} << 32) - 8;
    const std::array<std::uint32_t, 2> key{0x89abcdef, 0x01234567};
    const auto by_step = [&](int rounds) {
        return [=](State counter) {
            const State one = philox(counter, key, rounds);
            counter[2] = 1;
            const State two = philox(counter, key, rounds);
            return SixWords{one[0], one[1], one[2], two[0], two[1], two[2]};
        };
    };
    const auto seeded = [&](auto step) {
        return [=](State counter) {
            const State block = philox(counter, key);
            std::uint64_t state = std::uint64_t{block[1]} << 32 | block[0];
            SixWords words;
            for (std::uint32_t& word : words) word = step(state);
            return words;
        };
    };
    const auto pcg = [](std::uint64_t& state) {
        const std::uint64_t old = state;
        state = old * 6364136223846793005U + 1442695040888963407U;
        return std::rotr(static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27),
                         static_cast<int>(old >> 59));
    };
    const auto carry = [](std::uint64_t& state) {
        state = (state & 0xffffffffU) * 4294967118U + (state >> 32);
        return static_cast<std::uint32_t>(state);
    };
    const std::string philox_by_step = "#include \"core/streams/philox_by_step.cl\"\n";
    const std::vector<std::pair<std::string, std::function<SixWords(State)>>> all{
        {philox_by_step, by_step(10)},
        {"#define STEP_ROUNDS 7\n" + philox_by_step, by_step(7)},
        {"#include \"core/streams/pcg.cl\"\n", seeded(pcg)},
        {"#include \"core/streams/multiply_with_carry.cl\"\n", seeded(carry)},
    };
    for (const auto& [preamble, expected] : all) {
        const auto words = steps(preamble, first, 16, seed);
        for (std::uint32_t k = 0; k < 16; ++k) {
            const std::uint64_t number = first + k;
            EXPECT_EQ(words[k], expected({static_cast<std::uint32_t>(number),
                                          static_cast<std::uint32_t>(number >> 32), 0, 0}))
                << preamble;
        }
    }
}

}  // namespace
}  // namespace gonio::test

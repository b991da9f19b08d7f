// SPDX-License-Identifier: Apache-2.0
// Generators after their authors, one class each.
#include "timings/generators.hpp"

#include <array>
#include <bit>
#include <cstdlib>
#include <memory>

#include "timings/sobol.hpp"

namespace gonio {
namespace {

/// In (0, 1), as the kernels make it.
double uniform_of(std::uint32_t word)
{
    return double((word >> 8) | 1) * 0x1p-24;
}

/// Salmon et al., Parallel Random Numbers: As Easy as 1, 2, 3, SC 2011: Philox4x32 with so many
/// rounds. The counter is 64 bits, the key the seed.
template <int rounds>
class Philox {
public:
    explicit Philox(std::uint32_t seed) : seed_(seed) {}

    std::uint32_t operator()()
    {
        if (used_ == words_.size()) refill();
        return words_[used_++];
    }

    std::array<std::uint32_t, 4> block(std::uint64_t counter) const
    {
        std::array<std::uint32_t, 4> c{std::uint32_t(counter), std::uint32_t(counter >> 32), 0, 0};
        std::uint32_t key_0 = seed_, key_1 = 0;
        for (int round = 0; round < rounds; ++round) {
            const std::uint64_t p = std::uint64_t{c[0]} * 0xD2511F53U;
            const std::uint64_t q = std::uint64_t{c[2]} * 0xCD9E8D57U;
            c = {std::uint32_t(q >> 32) ^ c[1] ^ key_0, std::uint32_t(q),
                 std::uint32_t(p >> 32) ^ c[3] ^ key_1, std::uint32_t(p)};
            key_0 += 0x9E3779B9U;
            key_1 += 0xBB67AE85U;
        }
        return c;
    }

private:
    void refill()
    {
        words_ = block(counter_++);
        used_ = 0;
    }

    std::uint32_t seed_;
    std::uint64_t counter_ = 0;
    std::array<std::uint32_t, 4> words_{};
    std::size_t used_ = words_.size();
};

/// Blackman and Vigna, ACM TOMS 47(4), 2021, seeded by Philox: the kernels' own.
class Xoshiro {
public:
    explicit Xoshiro(std::uint32_t seed) : s_(Philox<10>(seed).block(0)) {}

    std::uint32_t operator()()
    {
        const std::uint32_t result = std::rotl(s_[0] + s_[3], 7) + s_[0], shifted = s_[1] << 9;
        s_[2] ^= s_[0];
        s_[3] ^= s_[1];
        s_[1] ^= s_[2];
        s_[0] ^= s_[3];
        s_[2] ^= shifted;
        s_[3] = std::rotl(s_[3], 11);
        return result;
    }

private:
    std::array<std::uint32_t, 4> s_;
};

/// PCG-XSH-RR 64/32: O'Neill, PCG, Harvey Mudd College HMC-CS-2014-0905, 2014.
class Pcg {
public:
    explicit Pcg(std::uint32_t seed) : state_(seed) { (*this)(); }

    std::uint32_t operator()()
    {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005U + 1442695040888963407U;
        return std::rotr(std::uint32_t(((old >> 18) ^ old) >> 27), int(old >> 59));
    }

private:
    std::uint64_t state_;
};

/// Multiply with carry, as GPU codes of photons use it: Alerstam, Svensson, Andersson-Engels,
/// J. Biomed. Opt. 13, 060504, 2008.
class MultiplyWithCarry {
public:
    explicit MultiplyWithCarry(std::uint32_t seed) : state_(0x1234567800000001U + seed) {}

    std::uint32_t operator()()
    {
        state_ = (state_ & 0xffffffffU) * 4294967118U + (state_ >> 32);
        return std::uint32_t(state_);
    }

private:
    std::uint64_t state_;
};

/// A linear congruence of 31 bits, as the C library's rand() of old (ISO C's example).
class Congruence {
public:
    explicit Congruence(std::uint32_t seed) : state_(seed) {}

    double operator()()
    {
        state_ = state_ * 1103515245U + 12345U;
        return (double((state_ >> 16) & 0x7fffU) + 0.5) * 0x1p-15;
    }

private:
    std::uint32_t state_;
};

/// Knuth's subtractive lagged Fibonacci generator (TAOCP 2, 3.2.2), lags 55 and 24, modulus 1e9:
/// the one behind MCML. Its differences of two earlier numbers show in threes.
class Subtractive {
public:
    explicit Subtractive(std::uint32_t seed)
    {
        std::int64_t last = std::abs(161803398 - std::int64_t{seed}) % modulus, next = 1;
        table_[54] = last;
        for (std::size_t k = 1; k < 55; ++k) {
            const std::size_t at = 21 * k % 55 - 1;
            table_[at] = next;
            next = last - next < 0 ? last - next + modulus : last - next;
            last = table_[at];
        }
        for (int warm = 0; warm < 4; ++warm)
            for (std::size_t k = 0; k < 55; ++k) {
                table_[k] -= table_[(k + 31) % 55];
                if (table_[k] < 0) table_[k] += modulus;
            }
    }

    double operator()()
    {
        first_ = (first_ + 1) % 55;
        second_ = (second_ + 1) % 55;
        std::int64_t value = table_[first_] - table_[second_];
        if (value < 0) value += modulus;
        table_[first_] = value;
        return (double(value) + 0.5) / double(modulus);
    }

private:
    static constexpr std::int64_t modulus = 1'000'000'000;
    std::array<std::int64_t, 55> table_{};
    std::size_t first_ = 54, second_ = 30;
};

/// Scrambled Sobol points for the first numbers of each photon, anew in each batch; a stream for
/// the rest of them.
class ScrambledSobol {
public:
    ScrambledSobol(std::uint32_t seed, std::size_t batch) : keys_(seed), batch_(batch), rest_(seed)
    {
    }

    void begin(std::size_t photon)
    {
        point_ = std::uint32_t(photon % batch_);
        dimension_ = 0;
        if (point_ == 0)
            for (std::size_t d = 0; d < sobol_dimensions; ++d)
                key_[d] = keys_.block(photon / batch_ * sobol_dimensions + d)[0];
    }

    std::uint32_t operator()()
    {
        if (dimension_ == sobol_dimensions) return rest_();
        const std::size_t d = dimension_++;
        return owen_scrambled(sobol(point_, d), key_[d]);
    }

private:
    Philox<10> keys_;
    std::size_t batch_;
    Xoshiro rest_;
    std::uint32_t point_ = 0;
    std::size_t dimension_ = sobol_dimensions;
    std::array<std::uint32_t, sobol_dimensions> key_{};
};

Numbers scrambled_sobol(std::uint32_t seed, std::size_t batch)
{
    const auto words = std::make_shared<ScrambledSobol>(seed, batch);
    return {[words] { return uniform_of((*words)()); },
            [words](std::size_t photon) { words->begin(photon); }};
}

template <class Words>
Numbers uniforms(std::uint32_t seed, std::size_t /*batch*/)
{
    return {[words = Words(seed)]() mutable { return uniform_of(words()); }};
}

template <class Uniform>
Numbers as_they_are(std::uint32_t seed, std::size_t /*batch*/)
{
    return {Uniform(seed)};
}

}  // namespace

const std::vector<Generator>& generators()
{
    static const std::vector<Generator> all{
        {"xoshiro128++ seeded by Philox", uniforms<Xoshiro>},
        {"Philox4x32-10", uniforms<Philox<10>>},
        {"Philox4x32-7", uniforms<Philox<7>>},
        {"PCG32", uniforms<Pcg>},
        {"multiply with carry", uniforms<MultiplyWithCarry>},
        {"scrambled Sobol, then xoshiro128++", scrambled_sobol},
        {"bad: congruence of 15 bits", as_they_are<Congruence>},
        {"bad: lagged Fibonacci (MCML's)", as_they_are<Subtractive>},
    };
    return all;
}

}  // namespace gonio

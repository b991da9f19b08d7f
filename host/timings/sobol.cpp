// SPDX-License-Identifier: Apache-2.0
// Sobol's sequence, and its scrambling after Owen.
#include "timings/sobol.hpp"

#include <array>

namespace gonio {
namespace {

constexpr std::size_t bits = 32;

/// What the bits of a point's number add to one coordinate.
using Directions = std::array<std::uint32_t, bits>;

/// A primitive polynomial over GF(2) by its degree and inner coefficients, and the first odd
/// numbers: rows 2 to 8 of new-joe-kuo-6.
struct Start {
    std::size_t degree;
    std::uint32_t coefficients;
    std::array<std::uint32_t, 5> m;
};
constexpr std::array<Start, sobol_dimensions - 1> starts{{{1, 0, {1}},
                                                          {2, 1, {1, 3}},
                                                          {3, 1, {1, 3, 1}},
                                                          {3, 2, {1, 1, 1}},
                                                          {4, 1, {1, 1, 3, 3}},
                                                          {4, 4, {1, 3, 5, 13}},
                                                          {5, 2, {1, 1, 5, 5, 17}}}};

constexpr Directions directions_of(const Start& start)
{
    Directions v{};
    for (std::size_t k = 0; k < bits; ++k) {
        if (k < start.degree) {
            v[k] = start.m[k] << (bits - 1 - k);
            continue;
        }
        const std::uint32_t before = v[k - start.degree];
        v[k] = before ^ (before >> start.degree);
        for (std::size_t j = 1; j < start.degree; ++j)
            if (((start.coefficients >> (start.degree - 1 - j)) & 1) != 0) v[k] ^= v[k - j];
    }
    return v;
}

constexpr std::array<Directions, sobol_dimensions> all_directions()
{
    std::array<Directions, sobol_dimensions> all{};
    for (std::size_t k = 0; k < bits; ++k) all[0][k] = 1U << (bits - 1 - k);  // van der Corput
    for (std::size_t d = 1; d < sobol_dimensions; ++d) all[d] = directions_of(starts[d - 1]);
    return all;
}

constexpr std::array<Directions, sobol_dimensions> directions = all_directions();

std::uint32_t reversed(std::uint32_t x)
{
    std::uint32_t result = 0;
    for (std::size_t k = 0; k < bits; ++k) result |= ((x >> k) & 1) << (bits - 1 - k);
    return result;
}

}  // namespace

std::uint32_t sobol(std::uint32_t point, std::size_t dimension)
{
    std::uint32_t x = 0;
    for (std::size_t k = 0; point != 0; point >>= 1, ++k)
        if ((point & 1) != 0) x ^= directions[dimension][k];
    return x;
}

std::uint32_t owen_scrambled(std::uint32_t coordinate, std::uint32_t key)
{
    std::uint32_t x = reversed(coordinate) + key;
    for (const std::uint32_t factor : {0x6c50b47cU, 0xb82f1e52U, 0xc7afe638U, 0x8d22f6e6U})
        x ^= x * factor;
    return reversed(x);
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Numbers in two floats against double: kernels/core/real.cl.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernels/kernel_fixtures.hpp"

namespace gonio {
namespace {

constexpr std::size_t count = std::size_t{1} << 16;

std::vector<float> random_floats(unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<float> floats;
    for (std::size_t k = 0; k < count; ++k)
        floats.push_back(static_cast<float>(random()) * 0x1p-31F - 1.0F);
    return floats;
}

/// hi + lo of a function of a = (x, 2^-25 x y) and b = (y, -2^-26 x y), in double.
std::vector<double> in_two(const std::string& function, const std::vector<float>& x,
                           const std::vector<float>& y)
{
    const auto part = [&](const char* name) {
        return on_device(
            "core/real.cl",
            "(" + function +
                "((two_floats){x, x * y * R(0x1p-25)}, (two_floats){y, x * y * R(-0x1p-26)}))" +
                name,
            x, y);
    };
    const std::vector<float> hi = part(".hi"), lo = part(".lo");
    std::vector<double> sums;
    for (std::size_t k = 0; k < count; ++k)
        sums.push_back(static_cast<double>(hi[k]) + static_cast<double>(lo[k]));
    return sums;
}

TEST(TwoFloats, MultiplyAndAddTo46Bits)
{
    const std::vector<float> x = random_floats(1), y = random_floats(2);
    const auto product = in_two("two_floats_product", x, y);
    const auto sum = in_two("two_floats_plus", x, y), difference = in_two("two_floats_minus", x, y);
    for (std::size_t k = 0; k < count; ++k) {
        const double xy = static_cast<double>(x[k] * y[k]);
        const double a = static_cast<double>(x[k]) + 0x1p-25 * xy;
        const double b = static_cast<double>(y[k]) - 0x1p-26 * xy;
        const double greater = std::max(std::abs(a), std::abs(b));
        ASSERT_NEAR(product[k], a * b, 0x1p-46 * std::abs(a * b)) << x[k] << ' ' << y[k];
        ASSERT_NEAR(sum[k], a + b, 0x1p-46 * greater) << x[k] << ' ' << y[k];
        ASSERT_NEAR(difference[k], a - b, 0x1p-46 * greater) << x[k] << ' ' << y[k];
    }
}

TEST(TwoFloats, KeepTheDigitsWhereASumCancels)
{
    const std::vector<float> x = random_floats(3);
    std::vector<float> y;
    for (const float number : x) y.push_back(-number);
    const std::vector<float> got = on_device(
        "core/real.cl",
        "two_floats_sum((two_floats){x, x * R(0x1p-30)}, (two_floats){y, x * R(0x1p-40)})", x, y);
    for (std::size_t k = 0; k < count; ++k) {
        const double exact = static_cast<double>(x[k]) * (0x1p-30 + 0x1p-40);
        ASSERT_NEAR(got[k], exact, 2e-7 * std::abs(exact));
    }
}

}  // namespace
}  // namespace gonio

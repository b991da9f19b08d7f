// SPDX-License-Identifier: Apache-2.0
// The errors that stand above the functions of kernels/core/math.cl and power.cl, in ulp against
// double over their ranges; and that every width gives the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <string_view>

#include "kernels/kernel_fixtures.hpp"

namespace gonio {
namespace {

struct Case {
    const char* name;
    const char* expression;
    double (*exact)(double x, double y);
    float from, to;  ///< of x, of one sign
    double (*y_of)(double x);
    double bound;  ///< in ulp
};

double nothing(double)
{
    return 0;
}

/// exp(x^2) erfc(x); beyond 20 by its asymptotic series, since erfc underflows.
double scaled_erfc(double x, double)
{
    if (x < 20) return std::exp(x * x) * std::erfc(x);
    const double t = 1 / (2 * x * x);
    return (1 - t * (1 - 3 * t * (1 - 5 * t))) / (x * std::sqrt(std::numbers::pi));
}

double exp_of_negative(double x, double)
{
    return std::exp(-x);
}
double log_of_positive(double x, double)
{
    return std::log(x);
}
double log_of_one_plus(double x, double)
{
    return std::log1p(x);
}
double log_of_one_minus(double x, double)
{
    return std::log1p(-x);
}
double two_to(double x, double)
{
    return std::exp2(x);
}
double power(double x, double y)
{
    return std::pow(x, y);
}
/// The y with x^y = 1e-6.
double down_to_a_millionth(double x)
{
    return std::log(1e-6) / std::log(x);
}
double angle_of(double x, double y)
{
    return std::atan2(x, y);
}
double hyperbolic_sine(double x, double)
{
    return std::sinh(x);
}
double one_less_exp(double x, double)
{
    return -std::expm1(-x);
}
/// The x with erfc(-x) = s, by Newton's method from the middle: erfc is convex from there to either
/// end.
double inverse_of_erfc(double s, double)
{
    if (s > 1) return -inverse_of_erfc(2 - s, 0);
    double x = 0, step = 1;
    while (std::abs(step) > 1e-12 * std::abs(x)) {
        step = (std::erfc(-x) - s) * std::exp(x * x) * std::sqrt(std::numbers::pi) / 2;
        x -= step;
    }
    return x;
}
double rest_of_circle(double x)
{
    return std::sqrt((1 - x) * (1 + x));
}
double one(double)
{
    return 1;
}

const Case cases[] = {
    {"ExpDownTo16", "exp_of_negative(x)", exp_of_negative, 1e-9F, 16.0F, nothing, 1.4},
    {"ExpDownTo87", "exp_of_negative(x)", exp_of_negative, 16.0F, 86.9999F, nothing, 5},
    {"ExpUpTo16", "exp_of_negative(x)", exp_of_negative, -1e-9F, -16.0F, nothing, 1.4},
    {"ExpUpTo87", "exp_of_negative(x)", exp_of_negative, -16.0F, -87.0F, nothing, 5},
    {"TwoToDownTo126", "two_to(x)", two_to, -1e-9F, -125.9999F, nothing, 2.5},
    {"TwoToUpTo126", "two_to(x)", two_to, 1e-9F, 126.0F, nothing, 2.5},
    {"PowerOfAMillionth", "power_of_parts(parts_of_positive(x), y)", power, 1e-6F, 0.999999F,
     down_to_a_millionth, 45},
    {"Log", "log_of_positive(x)", log_of_positive, 1.2e-38F, 1e38F, nothing, 1},
    {"LogNearOne", "log_of_positive(x)", log_of_positive, 0.5F, 2.0F, nothing, 1},
    {"LogOfOnePlus", "log_of_one_plus(x)", log_of_one_plus, 1e-30F, 1e30F, nothing, 2},
    {"LogOfOneMinus", "log_of_one_plus(x)", log_of_one_plus, -1e-30F, -0.9999999F, nothing, 1},
    {"LogOfCosine", "log_of_parts(parts_of_cosine(R(1.0) - x, x))", log_of_one_minus, 1e-30F,
     0.9999999F, nothing, 2.5},
    {"SinhUpTo16", "hyperbolic_sine(x)", hyperbolic_sine, 1e-9F, 16.0F, nothing, 2},
    {"OneLessExp", "one_less_exp_of_negative(x)", one_less_exp, 1e-30F, 87.0F, nothing, 1.5},
    {"InverseOfErfcBelow", "inverse_of_erfc(x)", inverse_of_erfc, 5.9604645e-8F, 0.99F, nothing, 9},
    {"InverseOfErfcAbove", "inverse_of_erfc(x)", inverse_of_erfc, 1.01F, 1.9999999F, nothing, 9},
    {"ScaledErfc", "scaled_erfc(x)", scaled_erfc, 1e-9F, 1e9F, nothing, 5},
    {"AngleOfSine", "angle_of(x, y)", angle_of, 1e-30F, 1.0F, rest_of_circle, 3},
    {"AngleOfTangent", "angle_of(x, y)", angle_of, 1e-30F, 1e30F, one, 3},
};

class Math : public testing::TestWithParam<Case> {
protected:
    Math() : x(floats_between(GetParam().from, GetParam().to, std::size_t{1} << 19))
    {
        for (const float number : x)
            y.push_back(static_cast<float>(GetParam().y_of(static_cast<double>(number))));
    }
    static void SetUpTestSuite()
    {
        std::vector<std::string> expressions;
        for (const Case& each : cases) expressions.emplace_back(each.expression);
        for (const unsigned width : {1U, 2U, 4U, 8U, 16U})
            functions.emplace(width, DeviceFunctions("core/power.cl", expressions, width));
    }
    static void TearDownTestSuite() { functions.clear(); }

    std::vector<float> on(unsigned width) const
    {
        const auto which =
            std::ranges::find(cases, std::string_view(GetParam().name),
                              [](const Case& each) { return std::string_view(each.name); });
        return functions.at(width)(static_cast<std::size_t>(which - std::begin(cases)), x, y);
    }

    static inline std::map<unsigned, DeviceFunctions> functions;

    std::vector<float> x, y;
};

TEST_P(Math, KeepsTheStatedError)
{
    const std::vector<float> got = on(8);
    double worst = 0;
    float at = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double exact = GetParam().exact(static_cast<double>(x[k]), static_cast<double>(y[k]));
        if (exact == 0) continue;
        const double error = ulps(got[k], exact);
        // Not std::max, which would let NaN pass.
        if (!(error <= worst)) {
            worst = error;
            at = x[k];
        }
    }
    RecordProperty("ulp", std::to_string(worst));
    EXPECT_LT(worst, GetParam().bound) << "at " << at;
    EXPECT_GT(worst, GetParam().bound / 2) << "the stated error is too cautious";
}

TEST_P(Math, HasTheSameBitsAtEveryWidth)
{
    const std::vector<float> narrow = on(1);
    for (const unsigned width : {2U, 4U, 8U, 16U}) EXPECT_EQ(narrow, on(width)) << width;
}

INSTANTIATE_TEST_SUITE_P(Core, Math, testing::ValuesIn(cases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(MathEnds, AreExact)
{
    const std::vector<float> zeros(16, 0.0F), ones(16, 1.0F), large(16, 87.0F);
    EXPECT_EQ(on_device("core/math.cl", "exp_of_negative(x)", zeros, zeros), ones);
    EXPECT_EQ(on_device("core/math.cl", "exp_of_negative(x)", large, zeros), zeros);
    EXPECT_EQ(on_device("core/math.cl", "log_of_positive(x)", ones, zeros), zeros);
    EXPECT_EQ(on_device("core/math.cl", "log_of_one_plus(x)", zeros, zeros), zeros);
    EXPECT_EQ(on_device("core/math.cl", "angle_of(x, y)", zeros, ones), zeros);
    EXPECT_EQ(on_device("core/math.cl", "scaled_erfc(x)", zeros, zeros)[0], 1.0F);
}

}  // namespace
}  // namespace gonio

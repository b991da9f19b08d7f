// SPDX-License-Identifier: Apache-2.0
// The series of the wave-optics models against a summation in 40 digits and against its closed
// forms.
#include "reference/wave_series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gonio::reference {
namespace {

struct Sum {
    double g, b, w;
};

// Term by term with mpmath 1.3 at 40 digits.
constexpr std::array sums{
    Sum{1e-8, 0, 9.999999925e-9},
    Sum{1e-8, 1, 3.678794390089746e-9},
    Sum{1e-8, 30, 9.43409847984683e-22},
    Sum{1e-8, 600, 2.140832292899437e-95},
    Sum{1e-4, 0, 9.999250030554688e-5},
    Sum{1e-4, 1, 3.678578172149443e-5},
    Sum{1e-4, 30, 7.765585589755892e-16},
    Sum{1e-4, 600, 2.638102681436493e-70},
    Sum{0.01, 0, 9.92530468939938e-3},
    Sum{0.01, 1, 3.657241676844533e-3},
    Sum{0.01, 30, 1.012696207824425e-11},
    Sum{0.01, 600, 7.102139149698177e-54},
    Sum{1, 0, 4.848291069956876e-1},
    Sum{1, 1, 2.093307647111137e-1},
    Sum{1, 30, 5.343983207195304e-6},
    Sum{1, 600, 3.084573636292521e-31},
    Sum{1, 5000, 7.858108091702731e-104},
    Sum{5, 0, 2.560326995816091e-1},
    Sum{5, 1, 1.814568793394332e-1},
    Sum{5, 30, 9.975327864042712e-4},
    Sum{5, 600, 7.117928726784664e-21},
    Sum{5, 5000, 1.813277563690306e-76},
    Sum{20, 0, 5.279778791525355e-2},
    Sum{20, 20, 1.788113819040997e-2},
    Sum{20, 200, 6.144718993943337e-6},
    Sum{150, 0, 6.711715882582098e-3},
    Sum{150, 150, 2.444223008237284e-3},
    Sum{150, 1500, 3.662418346811378e-7},
    Sum{199, 0, 5.050635208377216e-3},
    Sum{199, 199, 1.843939237276472e-3},
    Sum{199, 1990, 2.641220884189544e-7},
    Sum{205, 0, 4.902079755515153e-3},
    Sum{205, 205, 1.790105403947963e-3},
    Sum{205, 2050, 2.553574733742156e-7},
    Sum{1000, 0, 1.001002006024121e-3},
    Sum{1000, 1000, 3.676950570041936e-4},
    Sum{1000, 10000, 4.681088167690003e-8},
    Sum{1e5, 0, 1.000010000200006e-5},
    Sum{1e5, 100000, 3.678776017297844e-6},
    Sum{1e5, 1.2e+06, 6.147223261912034e-11},
    Sum{1e6, 0, 1.000001000002e-6},
    Sum{1e6, 1e+06, 3.678792572312772e-7},
    Sum{1e6, 1.2e+07, 6.14451342217891e-12},
    Sum{1e8, 0, 1.00000001e-8},
    Sum{1e8, 1e+08, 3.678794393320451e-9},
    Sum{1e8, 1.2e+09, 6.144215363992507e-14},
};

TEST(WaveSeriesTest, AgreesWithFortyDigits)
{
    for (const auto [g, b, w] : sums)
        EXPECT_NEAR(wave_series(g, b) / w, 1, 1e-11) << g << ", " << b;
}

// W(g, 0) = e^-g (Ei(g) - gamma - ln g), as g + g^2/4 + ... where that cancels.
TEST(WaveSeriesTest, ClosedFormInTheMirrorDirection)
{
    for (double g = 0.1; g < 600; g *= 1.3) {
        const double bracket = std::expint(g) - std::numbers::egamma - std::log(g);
        EXPECT_NEAR(wave_series(g, 0) / (std::exp(-g) * bracket), 1, 1e-12) << g;
    }
}

// e^-t/g (1 + (1 - 2 t + t^2/2)/g + ...) with t = b/g.
TEST(WaveSeriesTest, RoughLimit)
{
    for (const double g : {1e6, 1e7, 2e8})
        for (const double t : {0.0, 1.0, 12.0}) {
            const double limit = std::exp(-t) / g * (1 + (1 - 2 * t + t * t / 2) / g);
            EXPECT_NEAR(wave_series(g, t * g) / limit, 1, 2e-8) << g << ", " << t;
        }
}

TEST(WaveSeriesTest, SmoothLimit)
{
    for (const double b : {0.0, 1.0, 100.0})
        EXPECT_NEAR(wave_series(1e-60, b) / (1e-60 * std::exp(-b)), 1, 1e-13) << b;
    EXPECT_EQ(wave_series(0, 1), 0);
}

// Far outside of the lobe there is nothing, not NaN.
TEST(WaveSeriesTest, UnderflowsToZero)
{
    EXPECT_EQ(wave_series(1e-8, 1e9), 0);
    EXPECT_EQ(wave_series(1000, 1e9), 0);
    EXPECT_EQ(wave_series(3, 6e4), 0);
}

}  // namespace
}  // namespace gonio::reference

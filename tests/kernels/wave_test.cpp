// SPDX-License-Identifier: Apache-2.0
// The series of the wave-optics models on the device, against the reference in double.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/kernel_fixtures.hpp"
#include "reference/wave_series.hpp"

namespace gonio {
namespace {

struct Arguments {
    std::vector<float> g, b;
};

/// g from 1e-8 to 1.6e8, which is the catalogue's range, both sides of where the method changes
/// among them; b/g from 0 to 30, where W has fallen to e^-30 at the most, and b likewise for small
/// g.
Arguments arguments()
{
    std::vector<float> all_g = floats_between(1e-8F, 1.6e8F, 272);
    for (const float g : {63.9F, 64.0F, 64.00001F, 64.1F, 65.0F, 70.0F, 80.0F, 100.0F})
        all_g.push_back(g);
    Arguments at;
    for (const float g : all_g)
        for (int k = 0; k < 32; ++k) {
            const float fall = static_cast<float>(k * k) * (30.0F / 961);
            at.g.push_back(g);
            at.b.push_back(fall * std::max(g, 1.0F));
        }
    return at;
}

TEST(WaveSeries, AgreesWithTheReference)
{
    const Arguments at = arguments();
    const std::vector<float> got = on_device("core/wave.cl", "wave_series(x, y)", at.g, at.b);
    for (std::size_t k = 0; k < got.size(); ++k) {
        const double exact =
            reference::wave_series(static_cast<double>(at.g[k]), static_cast<double>(at.b[k]));
        ASSERT_NEAR(got[k], exact, 1.5e-5 * exact) << "g " << at.g[k] << " b " << at.b[k];
    }
}

TEST(WaveSeries, HasTheSameBitsAtEveryWidthWhateverTheNeighboursNeed)
{
    Arguments at = arguments();
    // Neighbours in a vector now differ in g, so that some are summed and some integrated.
    Arguments mixed;
    for (std::size_t k = 0; k < at.g.size(); ++k) {
        const std::size_t from = k * 1009 % at.g.size();
        mixed.g.push_back(at.g[from]);
        mixed.b.push_back(at.b[from]);
    }
    const auto narrow = on_device("core/wave.cl", "wave_series(x, y)", mixed.g, mixed.b, 1);
    for (const unsigned width : {4U, 8U, 16U})
        EXPECT_EQ(narrow, on_device("core/wave.cl", "wave_series(x, y)", mixed.g, mixed.b, width));
}

TEST(WaveSeries, VanishesWithoutARoughSurfaceAndFarFromTheMirror)
{
    const std::vector<float> zeros(16, 0.0F), g(16, 5.0F), rough(16, 1e6F), far(16, 1e9F);
    EXPECT_EQ(on_device("core/wave.cl", "wave_series(x, y)", zeros, zeros), zeros);
    EXPECT_EQ(on_device("core/wave.cl", "wave_series(x, y)", g, far), zeros);
    EXPECT_EQ(on_device("core/wave.cl", "wave_series(x, y)", rough, std::vector(16, 1e12F)), zeros);
}

}  // namespace
}  // namespace gonio

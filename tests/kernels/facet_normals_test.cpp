// SPDX-License-Identifier: Apache-2.0
// The inversion behind visible normals of a Beckmann surface, against its distribution in double.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernels/kernel_fixtures.hpp"

namespace gonio {
namespace {

/// The part of the visible normals of unit roughness whose slope towards the light, `cosine`, is
/// above `slope`: the integral of (cos + s sin) exp(-s^2).
double part_above(double slope, double cosine)
{
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const auto sum = [&](double from) {
        return cosine * std::erfc(from) +
               sine * std::exp(-from * from) / std::sqrt(std::numbers::pi);
    };
    return sum(slope) / sum(-cosine / std::max(sine, 1e-30));
}

TEST(BeckmannVisibleSlope, InvertsItsDistribution)
{
    const std::vector<float> u = floats_between(0x1p-24F, 1 - 0x1p-24F, 1 << 14);
    for (const float cosine : {1e-6F, 1e-3F, 0.05F, 0.2F, 0.5F, 0.8F, 0.95F, 0.999F, 1.0F}) {
        const std::vector<float> cosines(u.size(), cosine);
        const std::vector<float> slopes = on_device("core/facet_normals.cl",
                                                    "beckmann_visible_slope((stretched_light){y, "
                                                    "y, sqrt((R(1.0) - y) * (R(1.0) + y)), y}, "
                                                    "x)",
                                                    u, cosines);
        double worst = 0;
        for (std::size_t k = 0; k < u.size(); ++k) {
            const double part =
                part_above(static_cast<double>(slopes[k]), static_cast<double>(cosine));
            const double error = std::abs(part - static_cast<double>(u[k]));
            // Not std::max, which would let NaN pass.
            if (!(error <= worst)) worst = error;
        }
        EXPECT_LT(worst, 4e-7) << "at a cosine of " << cosine;
    }
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Tiles as they are planned are those that are computed.
#include "compute/tiling.hpp"

#include <gtest/gtest.h>

#include "compute/shared_device.hpp"
#include "compute/symmetry.hpp"
#include "gonio/errors.hpp"

namespace gonio {
namespace {

class Tiles : public test::SharedDevice {};

TEST_F(Tiles, AreThoseThatAreComputed)
{
    // Reciprocal, so that tiles are whole squares of rows, and not.
    for (const auto* model : {"ward", "lambert"})
        for (const std::size_t bytes : {1U, 20'000U, 100'000U, 1U << 26}) {
            const Material material{"m", {default_lobe(model)}};
            const Grid grid = isotropic_grid(16, 16, 64, Samples::centre);
            const bool reciprocal = is_reciprocal(material, Measure::brdf, grid);
            const Tiling planned =
                tiling(device()->info(), grid, material.channels(), reciprocal, bytes);
            std::size_t largest = 0;
            const ComputeReport report = compute_grid(
                *device(), material, Measure::brdf, grid,
                [&](const Rows<float>& rows) { largest = std::max(largest, rows.count); },
                {.tile_bytes = bytes});
            EXPECT_EQ(report.reciprocal, reciprocal);
            if (reciprocal) {
                EXPECT_EQ(planned.rows % 16, 0U) << "half a square of rows";
            }
            EXPECT_EQ(planned.tiles, report.tiles) << model << ", " << bytes;
            EXPECT_EQ(planned.rows, largest) << model << ", " << bytes;
            EXPECT_EQ(planned.bytes, largest * 64 * material.channels() * sizeof(float));
        }
}

TEST_F(Tiles, ThatFitIntoNoBufferAreRefused)
{
    DeviceInfo small = device()->info();
    small.largest_buffer_bytes = 1000;
    EXPECT_NO_THROW(tiling(small, isotropic_grid(4, 4, 250, Samples::centre), 1, false));
    EXPECT_THROW(tiling(small, isotropic_grid(4, 4, 251, Samples::centre), 1, false), UsageError);
}

}  // namespace
}  // namespace gonio

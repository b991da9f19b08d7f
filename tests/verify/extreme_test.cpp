// SPDX-License-Identifier: Apache-2.0
// Hard spots on the device, and that the textbook forms beside them are the same models.
#include "verify/extreme.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

/// The spot's model, far from everything hard.
HardSpot eased(HardSpot spot)
{
    for (std::size_t k = 0; k < spot.lobe.values.size(); ++k) {
        const Parameter& parameter = spot.lobe.model->parameters[k];
        if (parameter.is_number()) spot.lobe.values[k] = {parameter.preset};
    }
    spot.pairs = {{30, 0, 40, 150}, {20, 10, 60, 300}, {50, 0, 10, 80}};
    return spot;
}

TEST(HardSpots, TextbookFormsAreTheModelsWhereNothingIsHard)
{
    const Device device;
    for (const HardSpot& spot : hard_spots()) {
        const SpotVerdict verdict = verify_spot(device, eased(spot));
        EXPECT_LT(verdict.textbook.relative, 2e-5) << spot.name;
        EXPECT_LT(verdict.condition, 1e3) << spot.name;
        EXPECT_GT(verdict.device.maximum, 0) << spot.name;
    }
}

TEST(HardSpots, KeepTheirBoundsWhereTextbooksDoNot)
{
    const Device device;
    std::size_t lost = 0;
    for (const HardSpot& spot : hard_spots()) {
        const SpotVerdict verdict = verify_spot(device, spot);
        EXPECT_TRUE(verdict.passed()) << spot.name << ": " << verdict.device.relative;
        if (verdict.textbook.not_finite > 0 || verdict.textbook.relative > verdict.bound) ++lost;
    }
    EXPECT_GE(lost, 20U);
}

TEST(HardMedia, AgreeWithAddingDoubling)
{
    for (const MediumVerdict& medium : verify_media(Device()))
        EXPECT_TRUE(medium.passed()) << medium.name << ": " << medium.measured << " and not "
                                     << medium.exact << ", " << medium.deviation << " s.e.";
}

TEST(HardSums, AreExact)
{
    EXPECT_TRUE(verify_sum().passed());
    EXPECT_GT(verify_sum().textbook_error, 0.99);
}

}  // namespace
}  // namespace gonio

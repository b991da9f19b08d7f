// SPDX-License-Identifier: Apache-2.0
// Exposure and encoding against known values.
#include "output/tone.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

// IEC 61966-2-1: the two pieces meet at 0.0031308; 0.735357 is the code of half the light.
TEST(Tone, EncodesAsTheStandardSays)
{
    EXPECT_EQ(encode(0), 0);
    EXPECT_NEAR(encode(0.0031308f), 0.04045, 1e-5);
    EXPECT_NEAR(encode(0.0031309f), 0.04045, 1e-5);
    EXPECT_NEAR(encode(0.5f), 0.735357, 1e-5);
    EXPECT_NEAR(encode(1), 1, 1e-6);
}

TEST(Tone, ShowsDarkPartsAsTheyAreAndNeverExceedsWhite)
{
    EXPECT_EQ(to_screen({0, 0.25f, 0.4f}), glm::vec3(0, encode(0.25f), encode(0.4f)));
    float last = 0;
    for (float x = 0.01f; x < 4; x *= 1.1f) {
        const float shown = to_screen(glm::vec3(x)).y;
        EXPECT_GT(shown, last);
        last = shown;
    }
    EXPECT_LE(to_screen(glm::vec3(1e30f)).x, 1);
}

TEST(Tone, ExposesForTheBrightParts)
{
    std::vector<glm::vec3> radiance(99, glm::vec3(3, 1, 0));
    EXPECT_FLOAT_EQ(exposure_of(radiance), 0.25f);
    radiance.insert(radiance.end(), 900, glm::vec3(0));
    EXPECT_FLOAT_EQ(exposure_of(radiance), 0.25f) << "unlit parts count for nothing";
    radiance.emplace_back(100);
    EXPECT_FLOAT_EQ(exposure_of(radiance), 0.25f) << "a small highlight may be white";
    radiance.emplace_back(15000);
    EXPECT_FLOAT_EQ(exposure_of(radiance), 0.0025f) << "its tail is no surface";
    EXPECT_EQ(exposure_of(std::vector<glm::vec3>(9)), 1);
}

TEST(Tone, TakesThreeChannelsAsColourAndTheFirstOfFewerAsGrey)
{
    EXPECT_EQ(as_rgb({{1, 2}, {3, 4}, {5, 6}, {7, 8}}),
              (std::vector<glm::vec3>{{1, 3, 5}, {2, 4, 6}}));
    EXPECT_EQ(as_rgb({{1}, {2}}), (std::vector<glm::vec3>{{1, 1, 1}}));
    EXPECT_EQ(as_rgb({{4}}), (std::vector<glm::vec3>{{4, 4, 4}}));
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// What the polar plot shows of lobes made here.
#include "output/lobe_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "output/picture_fixtures.hpp"

namespace gonio {
namespace {

using test::Picture;

constexpr int width = 280;
constexpr double centre = 140, radius = 130;

/// theta: degrees from the normal, positive on the side of the mirror direction.
Picture plot(const std::function<glm::vec3(double theta)>& brdf)
{
    std::vector<glm::vec3> values;
    for (const DirectionPair& pair : lobe_pairs(45))
        values.push_back(brdf(pair.phi_o == 0 ? pair.theta_o : -pair.theta_o));
    const Surface page = make_image(CAIRO_FORMAT_RGB24, width, 180);
    const Context context = make_context(page.get());
    set_colour(context.get(), {1, 1, 1});
    cairo_paint(context.get());
    draw_lobe(context.get(), values, 45, 0, 0, width);
    return test::read_picture(page.get());
}

/// The pixel at a direction and a share of the outermost ring's radius.
test::Pixel at(const Picture& picture, double theta, double share)
{
    const double angle = theta * std::numbers::pi / 180;
    return picture.at(static_cast<int>(centre + share * radius * std::sin(angle)),
                      static_cast<int>(centre - share * radius * std::cos(angle)));
}

/// Filled parts are tinted; the page and the disc are nearly white.
bool is_filled(const test::Pixel& pixel)
{
    return std::min({pixel.red, pixel.green, pixel.blue}) < 225;
}

TEST(LobePlot, AsksForThePlaneOfIncidenceFromHorizonToHorizon)
{
    const auto pairs = lobe_pairs(45);
    bool mirror = false;
    for (const DirectionPair& pair : pairs) {
        EXPECT_EQ(pair.theta_i, 45);
        EXPECT_EQ(pair.phi_i, 180);
        EXPECT_TRUE(pair.phi_o == 0 || pair.phi_o == 180);
        mirror |= pair.theta_o == 45 && pair.phi_o == 0;
    }
    EXPECT_TRUE(mirror);
    EXPECT_EQ(pairs.front().theta_o, 90);
    EXPECT_EQ(pairs.front().phi_o, 180);
    EXPECT_EQ(pairs.back().theta_o, 90);
    EXPECT_EQ(pairs.back().phi_o, 0);
}

TEST(LobePlot, ADiffuserFillsTheHalfDisc)
{
    const Picture picture = plot([](double) { return glm::vec3(0.3f); });
    for (double theta = -85; theta <= 85; theta += 10)
        EXPECT_TRUE(is_filled(at(picture, theta, 0.95))) << theta;
    EXPECT_FALSE(is_filled(at(picture, 20, 1.06)));
}

TEST(LobePlot, AHighlightPointsAtTheMirrorDirection)
{
    const Picture picture = plot([](double theta) {
        return glm::vec3(static_cast<float>(std::exp(-0.02 * (theta - 45) * (theta - 45))));
    });
    EXPECT_TRUE(is_filled(at(picture, 41, 0.8)));
    EXPECT_TRUE(is_filled(at(picture, 49, 0.8)));
    for (const double theta : {-75.0, -15.0, 5.0, 75.0})
        EXPECT_FALSE(is_filled(at(picture, theta, 0.8))) << theta;
}

TEST(LobePlot, RadiusIsTheCubeRoot)
{
    const Picture picture = plot([](double theta) { return glm::vec3(theta < 0 ? 0.125f : 1.0f); });
    EXPECT_TRUE(is_filled(at(picture, -75, 0.45)));
    EXPECT_FALSE(is_filled(at(picture, -75, 0.56)));
    EXPECT_TRUE(is_filled(at(picture, 75, 0.9)));
}

TEST(LobePlot, ColourOfTheFillIsThatOfTheMaterial)
{
    const Picture red = plot([](double) { return glm::vec3(0.5f, 0.1f, 0.1f); });
    const test::Pixel pixel = at(red, 15, 0.8);
    EXPECT_GT(pixel.red, pixel.green + 20);
    EXPECT_EQ(pixel.green, pixel.blue);
    // The other channels' lines lie where (0.1 / 0.5)^(1/3) says.
    const auto line = test::extent_of(red, [&](int x, int y) {
        const test::Pixel p = red.at(x, y);
        return y < 100 && p.blue > p.red + 60;
    });
    EXPECT_NEAR(centre - line.top, std::cbrt(0.2) * radius, 1.5);
}

TEST(LobePlot, ABlackMaterialHasAPlotToo)
{
    const Picture picture = plot([](double) { return glm::vec3(0); });
    EXPECT_FALSE(is_filled(at(picture, 15, 0.5)));
}

}  // namespace
}  // namespace gonio

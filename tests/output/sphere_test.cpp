// SPDX-License-Identifier: Apache-2.0
// Geometry and shading of the lit sphere, with lobes made here.
#include "output/sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "output/picture_fixtures.hpp"

namespace gonio {
namespace {

using test::Picture;

constexpr int size = 120;
constexpr double radius = 60;
const glm::dvec3 key = glm::normalize(glm::dvec3(-0.5, 0.62, 0.6)), viewer(0, 0, 1);

/// The picture of a BRDF that depends on the slopes of the half vector.
Picture picture_of(const std::function<double(double slope_x, double slope_y)>& brdf,
                   glm::vec3 colour = glm::vec3(1))
{
    const Sphere sphere(size);
    std::vector<glm::vec3> values;
    for (const DirectionPair& pair : sphere.pairs()) {
        const auto [l, v] = unit_vectors(pair);
        const glm::dvec3 h = l + v;
        values.push_back(static_cast<float>(brdf(h.x / h.z, h.y / h.z)) * colour);
    }
    return test::read_picture(sphere.image(values, glm::vec3(0)).get());
}

Picture diffuse(glm::vec3 colour)
{
    return picture_of([](double, double) { return 1; }, colour);
}

TEST(Sphere, EveryPairIsOneOfThreeLightsAndTheViewerInALocalFrame)
{
    std::set<long> cosines;
    const Sphere sphere(size);
    for (const DirectionPair& pair : sphere.pairs()) {
        const auto [l, v] = unit_vectors(pair);
        EXPECT_GT(l.z, 0);
        EXPECT_GT(v.z, 0);
        cosines.insert(std::lround(1e6 * glm::dot(l, v)));
    }
    EXPECT_EQ(cosines.size(), 3u);
    EXPECT_TRUE(cosines.contains(std::lround(1e6 * glm::dot(key, viewer))));
}

TEST(Sphere, IsOpaqueInsideAndSmoothAtItsRim)
{
    const Picture picture = diffuse(glm::vec3(1));
    EXPECT_EQ(picture.at(0, 0), (test::Pixel{0, 0, 0, 0}));
    EXPECT_EQ(picture.at(size / 2, size / 2).alpha, 255);
    double covered = 0;
    int partly = 0;
    for (const test::Pixel& pixel : picture.pixels) {
        covered += pixel.alpha / 255.0;
        partly += pixel.alpha > 0 && pixel.alpha < 255;
        EXPECT_LE(std::max({pixel.red, pixel.green, pixel.blue}), pixel.alpha);
    }
    EXPECT_NEAR(covered / (size * size), 0.785398, 2e-3);
    EXPECT_GT(partly, 2 * size);
}

TEST(Sphere, ADiffuserIsBrightestWhereItFacesTheLight)
{
    const Picture picture = diffuse(glm::vec3(1));
    const int x = static_cast<int>(radius * (1 + key.x)),
              y = static_cast<int>(radius * (1 - key.y));
    const int facing = picture.at(x, y).red;
    for (const test::Pixel& pixel : picture.pixels) EXPECT_LE(pixel.red, facing + 1);
    EXPECT_GT(facing, 200);
    EXPECT_LT(picture.at(size - x, size - y).red, facing / 2);
}

TEST(Sphere, AHighlightLiesWhereTheNormalHalvesLightAndViewer)
{
    const Picture picture =
        picture_of([](double x, double y) { return std::exp(-400 * (x * x + y * y)); });
    const auto bright = test::extent_of(
        picture, [&](int x, int y) { return x + y < size && picture.at(x, y).red > 150; });
    const glm::dvec3 half = glm::normalize(key + viewer);
    EXPECT_NEAR(0.5 * (bright.left + bright.right), radius * (1 + half.x), 1.5);
    EXPECT_NEAR(0.5 * (bright.top + bright.bottom), radius * (1 - half.y), 1.5);
    EXPECT_LT(bright.width(), size / 6);
}

TEST(Sphere, SlopesAlongXLieAlongCirclesOfLatitude)
{
    const glm::dvec3 half = glm::normalize(key + viewer), pole(0, 0.906, 0.423);
    const glm::dvec3 east = glm::normalize(glm::cross(pole, half)), north = glm::cross(half, east);
    const auto red = [&](const Picture& picture, glm::dvec3 step) {
        const glm::dvec3 normal = glm::normalize(half + 0.2 * step);
        return picture
            .at(static_cast<int>(radius * (1 + normal.x)),
                static_cast<int>(radius * (1 - normal.y)))
            .red;
    };
    const Picture narrow_x =
        picture_of([](double x, double y) { return std::exp(-200 * x * x - y * y); });
    const Picture narrow_y =
        picture_of([](double x, double y) { return std::exp(-x * x - 200 * y * y); });
    for (const double side : {-1, 1}) {
        EXPECT_GT(red(narrow_x, side * north), 3 * red(narrow_x, side * east));
        EXPECT_GT(red(narrow_y, side * east), 3 * red(narrow_y, side * north));
    }
}

TEST(Sphere, KeepsColourAndExposesForIt)
{
    const Picture red = diffuse({0.5f, 0, 0}), brighter = diffuse({4, 0, 0});
    const test::Pixel centre = red.at(size / 2, size / 2);
    EXPECT_GT(centre.red, 150);
    EXPECT_EQ(centre.green, 0);
    EXPECT_EQ(centre.blue, 0);
    EXPECT_EQ(red.pixels, brighter.pixels);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Light that spreads in a picture against integrals with known answers.
#include "picture/spread.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compute/shared_device.hpp"
#include "skin/skin_fixtures.hpp"
#include "verify/picture_errors.hpp"

namespace gonio {
namespace {

using glm::dvec3;

class Spread : public test::SharedDevice {};

const SumOfGaussians gpu_gems = test::skin_of_gpu_gems();

/// A plane seen face to face, whose pixels are `side` mm wide.
EnteringLight plane(std::size_t width, std::size_t height, double side)
{
    EnteringLight seen{width,
                       height,
                       {},
                       std::vector<dvec3>(width * height),
                       std::vector<double>(width * height, side * side)};
    for (std::size_t k = 0; k < width * height; ++k)
        seen.place.emplace_back(side * static_cast<double>(k % width),
                                side * static_cast<double>(k / width), 0);
    return seen;
}

// Gaussians are 2 to 4 % off the photons in d'Eon & Luebke's measure, 20,000 photons have noise of
// their own, and the picture's pixels are 0.2 mm wide.
TEST_F(Spread, BehindAnEdgeOfLightItIsThatOfThePhotons)
{
    const Skin skin(find_skin_model("jacques_1998"));
    const RadialProfile profile = trace_profile(*device(), bands_of(skin), {.photons = 20'000});
    const SumOfGaussians gaussians = fit_gaussians(profile).function;
    EXPECT_LT(error_behind_an_edge(*device(), gaussians, profile), 0.015);
}

TEST_F(Spread, OnASphereItIsTheIntegralOverIt)
{
    constexpr std::size_t size = 240;
    constexpr double radius = 10, side = 2 * radius / size;
    EnteringLight seen = plane(size, size, side);
    const dvec3 towards(0.8, 0, 0.6);
    for (std::size_t k = 0; k < seen.area.size(); ++k) {
        const double x = seen.place[k].x + side / 2 - radius,
                     y = seen.place[k].y + side / 2 - radius;
        const double cosine = std::sqrt(std::max(0.0, 1 - (x * x + y * y) / (radius * radius)));
        seen.area[k] = cosine > 0.05 ? side * side / cosine : 0;
        seen.place[k] = {x, y, radius * cosine};
        seen.light[k] =
            dvec3(std::max(0.0, (towards.x * x + towards.z * radius * cosine) / radius));
    }
    const auto light = spread_light(*device(), seen, gpu_gems);
    double worst = 0;
    for (std::size_t x = 40; x < 200; x += 8) {
        const std::size_t k = size / 2 * size + x;
        const double cosine = (towards.x * seen.place[k].x + towards.z * seen.place[k].z) / radius;
        const auto expected = around_a_sphere(gpu_gems, cosine, 1 / radius);
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(light[k][c] - expected[static_cast<std::size_t>(c)]));
    }
    EXPECT_LT(worst, 0.001);
}

/// Rough, with holes.
EnteringLight rough(std::size_t width, std::size_t height)
{
    EnteringLight seen = plane(width, height, 0.1);
    std::mt19937 random(7);
    const auto number = [&] { return static_cast<double>(random()) / 0x1p32; };
    for (std::size_t k = 0; k < seen.area.size(); ++k) {
        seen.area[k] *= number() < 0.2 ? 0 : 1 + number();
        seen.place[k].z = number();
        seen.light[k] = {number(), number(), number()};
    }
    return seen;
}

TEST_F(Spread, EvenLightStaysAsItIs)
{
    EnteringLight seen = rough(23, 19);  // few enough for Oclgrind
    for (dvec3& light : seen.light) light = {0.5, 1, 2};
    const auto light = spread_light(*device(), seen, gpu_gems);
    for (std::size_t k = 0; k < light.size(); ++k)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(light[k][c], seen.area[k] > 0 ? 0.5 * (1 << c) : 0, 1e-5);
}

TEST_F(Spread, BitsDoNotDependOnTheVectorWidth)
{
    const EnteringLight seen = rough(61, 47), narrow = rough(5, 9);
    for (const unsigned width : {1U, 16U}) {
        const Device other("", width);
        EXPECT_EQ(spread_light(other, seen, gpu_gems), spread_light(*device(), seen, gpu_gems))
            << width;
        EXPECT_EQ(spread_light(other, narrow, gpu_gems), spread_light(*device(), narrow, gpu_gems));
    }
}

TEST_F(Spread, NothingIsWhereNoSurfaceIs)
{
    EnteringLight seen = rough(20, 20);
    seen.area.assign(400, 0);
    for (const dvec3 light : spread_light(*device(), seen, gpu_gems)) EXPECT_EQ(light, dvec3(0));
}

}  // namespace
}  // namespace gonio

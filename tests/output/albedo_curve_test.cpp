// SPDX-License-Identifier: Apache-2.0
// The albedo of a plot against closed forms.
#include "output/albedo_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

Material material(const std::string& model,
                  const std::vector<std::pair<std::string, double>>& parameters)
{
    Lobe lobe = default_lobe(model);
    for (const auto& [name, number] : parameters) lobe.set(name, std::vector{number});
    return {model, {lobe}};
}

double cosine(const AlbedoPoint& point)
{
    return std::cos(point.theta_i * std::numbers::pi / 180);
}

TEST(AlbedoCurve, CoversTheAnglesOfTheLight)
{
    const auto curve = albedo_curve(material("lambert", {}));
    EXPECT_EQ(curve.front().theta_i, 0);
    EXPECT_EQ(curve.back().theta_i, 89);
    for (std::size_t k = 1; k < curve.size(); ++k)
        EXPECT_GT(curve[k].theta_i, curve[k - 1].theta_i);
}

TEST(AlbedoCurve, IsThatOfClosedForms)
{
    for (const auto& point : albedo_curve(material("lambert", {{"rho", 0.8}})))
        EXPECT_NEAR(point.albedo[0], 0.8, 1e-6);
    // Minnaert: rho mu^(k - 1).
    for (const auto& point : albedo_curve(material("minnaert", {{"rho", 1}, {"k", 1.5}})))
        EXPECT_NEAR(point.albedo[0], std::sqrt(cosine(point)), 1e-6);
    // Lommel-Seeliger: (w/2)(1 - mu ln(1 + 1/mu)).
    for (const auto& point : albedo_curve(material("lommel_seeliger", {{"w", 1}}))) {
        const double mu = cosine(point);
        EXPECT_NEAR(point.albedo[0], 0.5 * (1 - mu * std::log(1 + 1 / mu)), 1e-5);
    }
}

/// Lafortune & Willems 1994: rho_s at normal incidence. The lobe of exponent 1e6 is 1e-3 wide.
TEST(AlbedoCurve, SeesNarrowLobes)
{
    for (const double exponent : {1.0, 100.0, 1e4, 1e6}) {
        const auto curve =
            albedo_curve(material("phong", {{"rho_s", 0.7}, {"exponent", exponent}}));
        EXPECT_NEAR(curve[0].albedo[0], 0.7, 7e-5) << exponent;
    }
    const auto mirror = albedo_curve(material("ggx", {{"f0", 1}, {"alpha", 1e-3}}));
    EXPECT_NEAR(mirror[10].albedo[0], 1, 1e-4);
}

/// At alpha = 1 this is Lommel and Seeliger's law with w = 2: E = 1 - mu ln(1 + 1/mu).
TEST(AlbedoCurve, OfTheRoughestFacetsIsThatOfADarkLayer)
{
    for (const auto& point : albedo_curve(material("ggx", {{"f0", 1}, {"alpha", 1}}))) {
        const double mu = cosine(point);
        EXPECT_NEAR(point.albedo[0], 1 - mu * std::log(1 + 1 / mu), 1e-5);
    }
}

TEST(AlbedoCurve, HasAValueForEachChannel)
{
    Material coloured = material("lambert", {});
    coloured.lobes[0].set("rho", std::vector{0.2, 0.4, 0.6});
    const auto curve = albedo_curve(coloured);
    ASSERT_EQ(curve[0].albedo.size(), 3U);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(curve[3].albedo[c], 0.2 * static_cast<double>(c + 1), 1e-6);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Light through folds of skin: which layers they have, limits, energy, and Burley's approximation.
#include "skin/transmittance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/adding_doubling.hpp"
#include "skin/fold.hpp"
#include "skin/skin_fixtures.hpp"

namespace gonio {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

double through(const LayeredMedium& medium, bool diffuse)
{
    const auto solution = reference::solve_layers_to(medium, {.incidence = {0.0}}, 1e-7);
    const auto& budget = (diffuse ? solution.diffuse : solution.collimated[0]).budget;
    return budget.unscattered_transmittance + budget.diffuse_transmittance;
}

/// Isotropic scattering, as much absorbed as the albedo leaves, extinction 1/cm; no interfaces.
LayeredMedium half_space(double albedo)
{
    return {.layers = {{1 - albedo, albedo, 1, inf, Isotropic{}}}};
}

TEST(Folds, HaveSkinOnBothSides)
{
    const LayeredMedium skin = test::skin_of("meglinski2002_A").layers_at(550);
    const LayeredMedium fold = fold_of(skin, 0.03);  // 20 and 80 um on each side, 100 um between
    ASSERT_EQ(fold.layers.size(), 5U);
    EXPECT_NEAR(fold.layers[2].d, 0.01, 1e-15);
    EXPECT_EQ(fold.layers[2].mus, skin.layers[2].mus);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(fold.layers[k].d, skin.layers[k].d);
        EXPECT_EQ(fold.layers[4 - k].mua, skin.layers[k].mua);
    }
    EXPECT_EQ(fold_of(skin, 0.003).layers.size(), 1U);  // all of it is horny layer
    const LayeredMedium thick = fold_of(skin, 5);       // which the fat has to fill
    EXPECT_EQ(thick.layers.size(), 13U);
    double sum = 0;
    for (const Layer& layer : thick.layers) sum += layer.d;
    EXPECT_NEAR(sum, 5, 1e-12);
    EXPECT_EQ(fold_of(half_space(0.9), 2).layers[0].d, 2);
}

// Two surfaces of Fresnel reflectance F, between which light goes to and fro: (1 - F)/(1 + F).
TEST(Folds, WithoutThicknessAreTheirSurfaces)
{
    const SkinTask task{
        .skin = test::skin_of("pyxopto_2layer"), .wavelengths = {450, 650}, .tolerance = 1e-6};
    const auto spectra = solve_folds(task, {1e-9, 1e-3, 0.1, 8}, [] {});
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(spectra.transmittance[0][k], 35.0 / 37, 1e-6);
        for (std::size_t d = 1; d < 4; ++d)
            EXPECT_LT(spectra.transmittance[d][k], spectra.transmittance[d - 1][k]);
        EXPECT_LT(spectra.transmittance[3][k], 1e-6);
    }
}

// Deep in a medium light falls as exp(-x/nu_0), 1 = c nu_0 atanh(1/nu_0) for albedo c (Case, de
// Hoffmann & Placzek, Introduction to the Theory of Neutron Diffusion, 1953).
TEST(Folds, DarkenWithTheDiffusionLength)
{
    for (const auto& [albedo, length] : {std::pair{0.9, 1.90320}, {0.99, 5.79673}}) {
        EXPECT_NEAR(albedo * length * std::atanh(1 / length), 1, 1e-5);
        const LayeredMedium medium = half_space(albedo);
        const double ratio =
            through(fold_of(medium, 11), true) / through(fold_of(medium, 10), true);
        // The other surface turns 1/sinh into an exponential: exp(-2 x/nu_0) is left.
        EXPECT_NEAR(-1 / std::log(ratio), length, 2 * std::exp(-20 / length) * length + 1e-3);
    }
}

TEST(Folds, LoseNoLight)
{
    for (const auto* name : {"meglinski2002_A_mel2", "delgado2011_bil0.1", "jacques1998_light"})
        for (const double thickness : {0.01, 0.05, 0.3}) {
            const LayeredMedium fold = fold_of(test::skin_of(name).layers_at(600), thickness);
            const auto solution = reference::solve_layers_to(fold, {.incidence = {0.3}}, 1e-5);
            for (const auto* light : {&solution.collimated[0], &solution.diffuse}) {
                const auto& [specular, reflected, straight, transmitted, absorbed, bottom] =
                    light->budget;
                double sum = specular + reflected + straight + transmitted + bottom;
                for (const double part : absorbed) sum += part;
                EXPECT_NEAR(sum, 1, 1e-9) << name << " " << thickness;
                EXPECT_NEAR(bottom, 0, 1e-12);
            }
        }
}

// Burley's diffusion profile as light through a slab of thickness t (Golubev, "Efficient Screen-
// Space Subsurface Scattering Using Burley's Normalized Diffusion in Real-Time", SIGGRAPH 2018):
// A/4 (exp(-t s) + 3 exp(-t s/3)), with s = 1.9 - A + 3.5 (A - 0.8)^2 and t in mean free paths
// (Burley 2015). It has A where nothing is in the way, and knows no back surface.
TEST(Folds, AgainstBurleysThickTransmittance)
{
    const LayeredMedium medium = half_space(0.99);
    const double a =
        reference::solve_layers_to(medium, {}, 1e-6).diffuse.budget.diffuse_reflectance;
    EXPECT_NEAR(a, 0.795, 1e-3);
    const double s = 1.9 - a + 3.5 * std::pow(a - 0.8, 2);
    const auto ratio = [&](double t) {
        return a / 4 * (std::exp(-t * s) + 3 * std::exp(-t * s / 3)) /
               through(fold_of(medium, t), true);
    };
    EXPECT_NEAR(ratio(0.3), 0.86, 0.01);
    EXPECT_NEAR(ratio(1), 0.88, 0.01);
    EXPECT_NEAR(ratio(4), 0.64, 0.01);
    EXPECT_NEAR(ratio(8), 0.33, 0.01);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Adding-doubling where media are thin, thick, clear, lossless or index-stepped, against closed
// forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "gonio/errors.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/chandrasekhar.hpp"
#include "reference/layered_media.hpp"
#include "reference/light_budgets.hpp"

namespace gonio::reference {
namespace {

using namespace gonio::test;

double sum(const LightBudget& budget)
{
    return reflectance(budget) + transmittance(budget) + budget.bottom_absorption +
           std::accumulate(budget.absorption.begin(), budget.absorption.end(), 0.0);
}

/// Fresnel reflection of a smooth surface for Lambertian light from outside, Walsh 1926 as in
/// Duntley, J. Opt. Soc. Am. 32, 1942, eq. 25.
double diffuse_fresnel_reflectance(double n)
{
    const double s = n * n, f = s * s;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           s * (s - 1) * (s - 1) / std::pow(s + 1, 3) * std::log((n - 1) / (n + 1)) -
           2 * n * s * (s + 2 * n - 1) / ((s + 1) * (f - 1)) +
           8 * f * (f + 1) / ((s + 1) * (f - 1) * (f - 1)) * std::log(n);
}

TEST(AddingDoublingExtremesTest, SendsAllLightSomewhere)
{
    std::vector<LayeredMedium> media = {van_de_hulst_slab(), giovanelli_half_space(), mcml_sample(),
                                        seven_layer_skin(), five_layer_skin()};
    media.push_back(in_air({layer(1.5, 1, 1e6, 0.5, 1), layer(1, 1e-6, 1e-6, 0.5, 1),
                            layer(2.5, 0.5, 0.5, -0.9, 1), layer(1.5, 0.1, 1e-6, 0, 1)}));
    for (const Bottom bottom : {Bottom::black, Bottom::mirror, Bottom::diffuse}) {
        media.push_back(mcml_sample());
        media.back().bottom = bottom;
        media.back().bottom_albedo = 0.7;
    }
    for (LayeredMedium& medium : media) {
        for (const double n_above : {1.0, 1.6}) {
            medium.n_above = n_above;
            const LayeredSolution solution =
                solve_layers(medium, {.incidence = {0, radians(60), radians(89.99)}}, 24);
            EXPECT_NEAR(sum(solution.diffuse.budget), 1, 1e-12);
            for (const Illumination& light : solution.collimated)
                EXPECT_NEAR(sum(light.budget), 1, 1e-12);
        }
    }
}

TEST(AddingDoublingExtremesTest, StatesAtLeastItsError)
{
    for (const LayeredMedium& medium :
         {van_de_hulst_slab(), van_de_hulst_slab(1.5), giovanelli_half_space(), mcml_sample(),
          seven_layer_skin(), five_layer_skin()}) {
        const LightRequest request{.incidence = {0, radians(70)}};
        const LayeredSolution exact = solve_layers(medium, request, 90);
        for (const int nodes : {16, 24, 36, 48}) {
            const LayeredSolution solution = solve_layers(medium, request, nodes);
            for (std::size_t i = 0; i < request.incidence.size(); ++i) {
                const LightBudget &a = solution.collimated[i].budget,
                                  &b = exact.collimated[i].budget;
                const double allowed = solution.error + exact.error;
                EXPECT_NEAR(a.diffuse_reflectance, b.diffuse_reflectance, allowed)
                    << nodes << " nodes";
                EXPECT_NEAR(a.diffuse_transmittance, b.diffuse_transmittance, allowed)
                    << nodes << " nodes";
                for (std::size_t k = 0; k < a.absorption.size(); ++k) {
                    EXPECT_NEAR(a.absorption[k], b.absorption[k], allowed) << nodes << " nodes";
                }
            }
        }
    }
}

TEST(AddingDoublingExtremesTest, ReachesTheErrorThatIsAsked)
{
    const LayeredSolution solution = solve_layers_to(seven_layer_skin(), {.incidence = {0}}, 1e-6);
    EXPECT_LE(solution.error, 1e-6);
    EXPECT_NEAR(solution.collimated[0].budget.diffuse_reflectance, .56258497, 1e-6);
    EXPECT_THROW(
        solve_layers_to(in_air({layer(1.4, 1, 100, 0.99999, 0.1)}), {.incidence = {0}}, 1e-15),
        RunError);
}

TEST(AddingDoublingExtremesTest, LosesNothingWhereNothingAbsorbs)
{
    // A slab that only scatters, isotropically, transmits (4/3) / (depth + 2 q) of Lambertian light
    // with the extrapolation length q of Milne's problem (Placzek and Seidel, Phys. Rev. 72, 1947),
    // but for terms of order exp(-depth).
    constexpr double q = 0.710446089598763;
    for (const auto& [depth, error] : {std::pair{40.0, 1e-10}, {1e3, 1e-9}, {1e6, 1e-3}}) {
        const LightBudget budget =
            solve_layers(in_air({layer(1, 0, depth, 0, 1)}), {}, 40).diffuse.budget;
        const double expected = 4.0 / 3 / (depth + 2 * q);
        EXPECT_NEAR(transmittance(budget), expected, expected * error) << "optical depth " << depth;
        EXPECT_NEAR(budget.absorption[0], 0, 2e-9) << "optical depth " << depth;
    }
    for (const double g : {0.0, 0.9}) {
        for (const double n : {1.0, 1.4}) {
            const LayeredSolution solution = solve_layers(in_air({layer(n, 0, 1, g, infinite)}),
                                                          {.incidence = {0, radians(89.99)}}, 40);
            EXPECT_NEAR(reflectance(solution.diffuse.budget), 1, 1e-6);
            for (const Illumination& light : solution.collimated)
                EXPECT_NEAR(reflectance(light.budget), 1, 1e-6);
        }
    }
}

TEST(AddingDoublingExtremesTest, MatchesChandrasekharForEveryAlbedoAndIncidence)
{
    const std::vector<double> incidence = {0, radians(30), radians(60), radians(85),
                                           radians(89.99)};
    for (const double albedo : {1e-7, 0.1, 0.9, 0.999, 1 - 1e-7}) {
        const LayeredSolution solution = solve_layers(
            in_air({layer(1, 1 - albedo, albedo, 0, infinite)}), {.incidence = incidence}, 40);
        const auto expect_equal = [&](const Illumination& light, double expected) {
            EXPECT_NEAR(reflectance(light.budget), expected, solution.error + 1e-10)
                << "albedo " << albedo;
        };
        for (std::size_t i = 0; i < incidence.size(); ++i) {
            expect_equal(solution.collimated[i],
                         chandrasekhar_plane_albedo(std::cos(incidence[i]), albedo));
        }
        expect_equal(solution.diffuse, chandrasekhar_spherical_albedo(albedo));
        EXPECT_LT(solution.error, 1e-4);
    }
}

TEST(AddingDoublingExtremesTest, IsSmoothThroughIsotropicScattering)
{
    const auto value = [](double g) {
        return reflectance(solve_layers(in_air({layer(1.4, 1, 9, g, 1)}), {.incidence = {0}}, 32)
                               .collimated[0]
                               .budget);
    };
    const double slope = (value(1e-3) - value(-1e-3)) / 2e-3;
    EXPECT_NEAR(value(1e-6) - value(0), slope * 1e-6, 1e-11);
    EXPECT_NEAR(value(-1e-6) - value(0), slope * -1e-6, 1e-11);
}

TEST(AddingDoublingExtremesTest, DoesNotCareHowALayerIsDivided)
{
    // Optical depths from 1e-6 to 1e3 behind each other, 20 layers in all.
    const auto material = [](double depth) { return layer(1.4, 0.001, 0.999, 0.8, depth); };
    std::vector<Layer> parts;
    double depth = 0;
    for (int i = 0; i < 20; ++i) {
        parts.push_back(material(std::pow(10, (i * 7) % 10 - 6)));
        depth += parts.back().d;
    }
    const LayeredSolution divided = solve_layers(in_air(parts), {.incidence = {radians(40)}}, 24);
    const LayeredSolution whole =
        solve_layers(in_air({material(depth)}), {.incidence = {radians(40)}}, 24);
    const LightBudget &a = divided.collimated[0].budget, &b = whole.collimated[0].budget;
    EXPECT_NEAR(a.diffuse_reflectance, b.diffuse_reflectance, 1e-12);
    EXPECT_NEAR(a.diffuse_transmittance, b.diffuse_transmittance, 1e-12);
    EXPECT_NEAR(std::accumulate(a.absorption.begin(), a.absorption.end(), 0.0), b.absorption[0],
                1e-12);
}

TEST(AddingDoublingExtremesTest, HidesWhatLiesUnderAThickLayer)
{
    const Layer thick = layer(1.5, 1e5, 9e5, 0.5, 1);
    LayeredMedium stack = in_air({thick, layer(1, 1e-6, 1e-6, 0.5, 1), layer(2.5, 0.5, 0.5, 0, 1)});
    LayeredMedium half_space = in_air({thick});
    half_space.layers[0].d = infinite;
    const LightBudget a = solve_layers(stack, {.incidence = {0.3}}, 40).collimated[0].budget;
    const LightBudget b = solve_layers(half_space, {.incidence = {0.3}}, 40).collimated[0].budget;
    EXPECT_NEAR(a.diffuse_reflectance, b.diffuse_reflectance, 1e-7);
    EXPECT_LT(transmittance(a), 1e-300);
}

TEST(AddingDoublingExtremesTest, FollowsClearLayersInClosedForm)
{
    for (const double n : {1.2, 1.5, 2.5}) {
        const double r = std::pow((n - 1) / (n + 1), 2);
        const LayeredMedium glass = in_air({layer(n, 0, 0, 0, 0.1)});
        const LayeredSolution clear = solve_layers(glass, {.incidence = {0}}, 24);
        EXPECT_NEAR(clear.collimated[0].budget.specular, 2 * r / (1 + r), 1e-14);
        EXPECT_NEAR(clear.collimated[0].budget.unscattered_transmittance, (1 - r) / (1 + r), 1e-14);

        const double t = std::exp(-1.0);
        const LightBudget filter =
            solve_layers(in_air({layer(n, 10, 0, 0, 0.1)}), {.incidence = {0}}, 24)
                .collimated[0]
                .budget;
        EXPECT_NEAR(filter.specular, r, 1e-14);
        EXPECT_NEAR(filter.diffuse_reflectance, (1 - r) * (1 - r) * r * t * t / (1 - r * r * t * t),
                    1e-14);
        EXPECT_NEAR(filter.unscattered_transmittance, (1 - r) * (1 - r) * t / (1 - r * r * t * t),
                    1e-14);
        EXPECT_NEAR(filter.diffuse_transmittance, 0, 1e-14);
    }
}

TEST(AddingDoublingExtremesTest, EndsAtEveryBottom)
{
    LayeredMedium paint = in_air({layer(1.5, 0, 0, 0, 0.1)});
    const LightRequest normal{.incidence = {0}};
    paint.bottom = Bottom::mirror;
    EXPECT_NEAR(reflectance(solve_layers(paint, normal, 24).collimated[0].budget), 1, 1e-13);
    paint.bottom = Bottom::black;
    EXPECT_NEAR(solve_layers(paint, normal, 24).collimated[0].budget.bottom_absorption, 0.96,
                1e-13);

    // Saunderson, J. Opt. Soc. Am. 32, 1942, for light that a Lambertian ground sends back through
    // the surface.
    paint.bottom = Bottom::diffuse;
    paint.bottom_albedo = 0.5;
    const double outside = diffuse_fresnel_reflectance(1.5), inside = 1 - (1 - outside) / 2.25;
    const double ground = 0.5 * (1 - inside) / (1 - 0.5 * inside);
    const LayeredSolution solution = solve_layers(paint, normal, 40);
    EXPECT_NEAR(solution.collimated[0].budget.diffuse_reflectance, 0.96 * ground, 1e-10);
    EXPECT_NEAR(reflectance(solution.diffuse.budget), outside + (1 - outside) * ground, 1e-10);
}

TEST(AddingDoublingExtremesTest, ReflectsTotallyFromTheCriticalAngleOn)
{
    LayeredMedium medium = in_air({layer(1, 0.1, 1, 0.5, 1)});
    medium.n_above = 1.5;
    const double critical = std::asin(1 / 1.5);
    const LayeredSolution solution = solve_layers(
        medium, {.incidence = {critical - 1e-9, critical, critical + 1e-9, radians(89.99)}}, 40);
    EXPECT_LT(reflectance(solution.collimated[0].budget), 0.9999);
    EXPECT_GT(reflectance(solution.collimated[0].budget), 0.999);
    for (std::size_t i = 1; i < 4; ++i)
        EXPECT_NEAR(solution.collimated[i].budget.specular, 1, 1e-7);
    // Reciprocity of the interface: a fraction 1 / n^2 of the directions of dense media enters thin
    // ones.
    const double outside = diffuse_fresnel_reflectance(1.5);
    EXPECT_NEAR(solution.diffuse.budget.specular, 1 - (1 - outside) / 2.25, 1e-12);
}

TEST(AddingDoublingExtremesTest, TellsPhaseFunctionsByTheirShapeAlone)
{
    const auto value = [](const PhaseFunction& phase) {
        LayeredMedium medium = mcml_sample();
        for (Layer& layer : medium.layers) layer.phase = phase;
        return solve_layers(medium, {.incidence = {0}}, 32)
            .collimated[0]
            .budget.diffuse_reflectance;
    };
    const auto tabulated = [](auto density) {
        TabulatedPhase table;
        for (int i = 0; i <= 4000; ++i) {
            table.cosine.push_back(i == 4000 ? 1 : -1 + i / 2000.0);
            table.value.push_back(density(table.cosine.back()));
        }
        return table;
    };
    const double isotropic = value(Isotropic{});
    EXPECT_NEAR(value(HenyeyGreenstein{0}), isotropic, 1e-13);
    EXPECT_NEAR(value(TabulatedPhase{{-1, 1}, {3, 3}}), isotropic, 1e-13);
    EXPECT_NEAR(value(TwoTermHenyeyGreenstein{0.5, 0.5, 0.3}), value(HenyeyGreenstein{0.5}), 1e-13);
    EXPECT_NEAR(value(tabulated([](double c) { return 1 + c * c; })), value(Rayleigh{}), 1e-7);
    EXPECT_NEAR(value(tabulated([](double c) { return std::pow(1.25 - c, -1.5); })),
                value(HenyeyGreenstein{0.5}), 1e-6);
    EXPECT_GT(std::abs(value(Rayleigh{}) - isotropic), 1e-4);
}

TEST(AddingDoublingExtremesTest, RefusesAnglesBeyondTheHorizon)
{
    EXPECT_THROW(solve_layers(van_de_hulst_slab(), {.incidence = {radians(90)}}, 24), UsageError);
    EXPECT_THROW(solve_layers(van_de_hulst_slab(), {.exit_above = {-0.1}}, 24), UsageError);
    EXPECT_THROW(solve_layers({}, {.incidence = {0}}, 24), UsageError);
}

}  // namespace
}  // namespace gonio::reference

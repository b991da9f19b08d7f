// SPDX-License-Identifier: Apache-2.0
// Single-scattering albedos of half-spaces: there and back, exact values, and the fits of
// renderers.
#include "photon/albedo_inversion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "gonio/errors.hpp"
#include "gonio/quantity.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/chandrasekhar.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

const LightSource diffuse{.beam = Beam::diffuse};

LightJob job(double n, double g, const LightSource& light, double error = 1e-6)
{
    return {.medium = in_air({layer(n, 1, 1, g, infinite)}),
            .quantity = &find_quantity("single_scattering_albedo", Substance::layers),
            .solver = "adding_doubling",
            .light = light,
            .budget = {error, {}, {}}};
}

Axis albedos(std::vector<double> values)
{
    return {"albedo", "1", std::move(values), Samples::node};
}

std::vector<Fraction> inverted(const LightJob& light, const std::vector<double>& values)
{
    return invert_albedos(light, albedos(values), [](double) {}).values;
}

TEST(AlbedoInversion, IsChandrasekhars)
{
    for (const double alpha : {0.1, 0.5, 0.9, 0.99, 0.9999}) {
        const Fraction by_diffuse =
            inverted(job(1, 0, diffuse), {reference::chandrasekhar_spherical_albedo(alpha)})[0];
        EXPECT_NEAR(by_diffuse.mean, alpha, by_diffuse.error + 1e-12);
        EXPECT_LT(by_diffuse.error, 2e-5);
        const Fraction by_beam = inverted(job(1, 0, {.incidence = std::acos(0.5)}),
                                          {reference::chandrasekhar_plane_albedo(0.5, alpha)})[0];
        EXPECT_NEAR(by_beam.mean, alpha, by_beam.error + 1e-12);
    }
}

TEST(AlbedoInversion, GoesThereAndBack)
{
    for (const double n : {1.0, 1.4})
        for (const double g : {-0.5, 0.0, 0.8})
            for (const LightSource& light : {diffuse, LightSource{.incidence = 1}}) {
                const std::vector<double> wanted{0.2, 0.6, 0.999};
                double before = 0;
                const auto found = inverted(job(n, g, light, 1e-5), wanted);
                for (std::size_t k = 0; k < wanted.size(); ++k) {
                    EXPECT_GT(found[k].mean, before);
                    before = found[k].mean;
                    const LayeredMedium medium =
                        in_air({layer(n, 1 - found[k].mean, found[k].mean, g, infinite)});
                    const auto budget =
                        reference::solve_layers_to(medium, {.incidence = {light.incidence}}, 1e-7)
                            .under(light)
                            .budget;
                    EXPECT_NEAR(budget.specular + budget.diffuse_reflectance, wanted[k], 1.02e-5)
                        << n << " " << g;
                }
            }
}

TEST(AlbedoInversion, HasItsEnds)
{
    const auto ends = inverted(job(1, 0.5, diffuse), {0, 1});
    EXPECT_EQ(ends[0].mean, 0);
    EXPECT_EQ(ends[1].mean, 1);
    // ((1.4 - 1) / (1.4 + 1))^2
    EXPECT_THROW(check_inversion(job(1.4, 0, {}), albedos({0.0277})), UsageError);
    EXPECT_NO_THROW(check_inversion(job(1.4, 0, {}), albedos({0.0278})));
    LightJob slab = job(1, 0, {});
    slab.medium.layers[0].d = 1;
    EXPECT_THROW(check_inversion(slab, albedos({0.5})), UsageError);
}

/// Chiang, Kutz & Burley, SIGGRAPH 2016 talks, for isotropic scattering.
double chiang(double a)
{
    return 1 - std::exp(a * (-5.09406 + a * (2.61188 - a * 4.31805)));
}

double polynomial(const std::array<double, 8>& c, double g)
{
    double sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * g + c[k];
    return sum;
}

/// The fit for Henyey-Greenstein's g from 0 on of Blender 3.4 (Cycles' subsurface_random_walk.h),
/// which names Wrenninge, Villemin & Hery, "Path Traced Subsurface Scattering using Anisotropic
/// Phase Functions and Non-Exponential Free Flights", Pixar 2017.
double wrenninge(double albedo, double g)
{
    const double a = polynomial({1.8260523782, -1.28451056436, -1.79904629312, 9.19393289202,
                                 -22.8215585862, 32.0234874259, -23.6264803333, 7.21067002658},
                                g);
    const double b =
        4.98511194385 +
        0.127355959438 *
            std::exp(polynomial({0, 31.1491581433, -201.847017512, 841.576016723, -2018.09288505,
                                 2731.71560286, -1935.41424244, 559.009054474},
                                g));
    const double c = polynomial({1.09686102424, -0.394704063468, 1.05258115941, -8.83963712726,
                                 28.8643230661, -46.8802913581, 38.5402837518, -12.7181042538},
                                g);
    const double d = polynomial({0.496310210422, 0.360146581622, -2.15139309747, 17.8896899217,
                                 -55.2984010333, 82.065982243, -58.5106008578, 15.8478295021},
                                g);
    const double e =
        4.23190299701 +
        0.00310603949088 *
            std::exp(polynomial({0, 76.7316253952, -594.356773233, 2448.8834203, -5576.68528998,
                                 7116.60171912, -4763.54467887, 1303.5318055},
                                g));
    const double f = polynomial({2.40602999408, -2.51814844609, 9.18494908356, -79.2191708682,
                                 259.082868209, -403.613804597, 302.85712436, -87.4370473567},
                                g);
    const double blend = std::pow(albedo, 0.25);
    return (1 - blend) * a * std::pow(std::atan(b * albedo), c) +
           blend * d * std::pow(std::atan(e * albedo), f);
}

// Both are fits for diffuse light, the second is for isotropic scattering only.
TEST(AlbedoInversion, AgainstTheFitsOfRenderers)
{
    const std::vector<double> wanted{0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 0.95};
    double of_wrenninge = 0, of_chiang = 0;
    for (const double g : {0.0, 0.3, 0.6, 0.8, 0.9}) {
        const auto found = inverted(job(1, g, diffuse, 1e-4), wanted);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const double alpha = found[k].mean;
            of_wrenninge = std::max(of_wrenninge, std::abs(wrenninge(wanted[k], g) - alpha));
            if (g == 0) of_chiang = std::max(of_chiang, std::abs(chiang(wanted[k]) - alpha));
        }
    }
    EXPECT_NEAR(of_wrenninge, 0.010, 0.0005);
    EXPECT_NEAR(of_chiang, 0.007, 0.0005);
}

}  // namespace
}  // namespace gonio::test

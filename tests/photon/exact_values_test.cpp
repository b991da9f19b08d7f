// SPDX-License-Identifier: Apache-2.0
// Quantities of layers without noise, against closed forms, and against photons.
#include "photon/exact_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gonio/quantity.hpp"
#include "photon/bins.hpp"
#include "photon/photon_fixtures.hpp"
#include "reference/chandrasekhar.hpp"
#include "reference/layered_brdf.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

using std::numbers::pi;

LightJob job(const LayeredMedium& medium, std::string_view quantity, LightSource light = {})
{
    return {medium, &find_quantity(quantity, Substance::layers), "adding_doubling", light, 1, {}};
}

Axis even_axis(const std::string& name, double to, std::size_t count)
{
    Axis axis{name, "", {}, Samples::centre};
    for (std::size_t k = 0; k < count; ++k)
        axis.values.push_back(to * (double(k) + 0.5) / double(count));
    return axis;
}

TEST(ExactValues, AreChandrasekhars)
{
    const LayeredMedium medium = in_air({layer(1, 1, 9, 0, infinite)});
    const std::vector<Axis> axes = {even_axis("theta_i", 90, 3), even_axis("theta_o", 90, 4),
                                    even_axis("delta_phi", 360, 4)};
    const ExactValues brdf = exact_values(job(medium, "brdf"), axes);
    std::size_t k = 0;
    for (const double in : axes[0].values)
        for (const double out : axes[1].values)
            for (int phi = 0; phi < 4; ++phi, ++k)
                EXPECT_NEAR(brdf.values[k].mean,
                            reference::chandrasekhar_brdf(std::cos(radians(in)),
                                                          std::cos(radians(out)), 0.9),
                            brdf.values[k].error + 1e-9);
    const Axis mu = even_axis("mu", 1, 8);
    const ExactValues albedo = exact_values(job(medium, "directional_albedo"), {mu});
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(albedo.values[i].mean, reference::chandrasekhar_plane_albedo(mu.values[i], 0.9),
                    1e-6);
    EXPECT_NEAR(
        exact_values(job(medium, "mean_albedo", {.beam = Beam::diffuse}), {}).values[0].mean,
        reference::chandrasekhar_spherical_albedo(0.9), 1e-6);
}

TEST(ExactValues, HaveTheMirrorDirectionAtHalfATurn)
{
    const LayeredMedium medium = in_air({layer(1, 1, 9, 0.6, 0.1)});
    const std::vector<Axis> axes = {
        {"theta_i", "deg", {60}}, {"theta_o", "deg", {60}}, {"delta_phi", "deg", {0, 180}}};
    const ExactValues brdf = exact_values(job(medium, "brdf"), axes);
    EXPECT_GT(brdf.values[1].mean, 2 * brdf.values[0].mean);
}

/// What leaves by angle adds up to the budget, with unscattered light in its bin.
TEST(ExactValues, AddUpToTheBudgetByAngle)
{
    constexpr std::size_t bins = 30;
    const LayeredMedium medium = van_de_hulst_slab(1.3);
    for (const LightSource& light :
         {LightSource{.incidence = radians(40)}, LightSource{.beam = Beam::diffuse}}) {
        const auto budget = exact_values(job(medium, "light_budget", light), {}).values;
        const Axis alpha = even_axis("alpha", 90, bins);
        double up = 0, down = 0;
        const auto reflected = exact_values(job(medium, "reflectance_alpha", light), {alpha});
        const auto transmitted = exact_values(job(medium, "transmittance_alpha", light), {alpha});
        for (std::size_t k = 0; k < bins; ++k) {
            up += reflected.values[k].mean * solid_angle(k, bins);
            down += transmitted.values[k].mean * solid_angle(k, bins);
        }
        EXPECT_NEAR(up, budget[1].mean, 1e-5);
        EXPECT_NEAR(down, budget[2].mean + budget[3].mean, 1e-5);
        if (light.beam == Beam::diffuse) continue;
        EXPECT_GT(transmitted.values[13].mean, 2 * transmitted.values[12].mean);  // at 40 degrees
    }
}

TEST(MeanPath, IsThatOfStraightLight)
{
    const LightJob straight = job(in_air({layer(1.5, 2, 0, 0, 0.3), layer(1.5, 0.5, 0, 0, 0.2)}),
                                  "mean_path", {.incidence = radians(30)});
    const ExactValues paths = exact_values(straight, {});
    const double cosine = std::sqrt(1 - std::pow(0.5 / 1.5, 2));
    // Reflections between the outer boundaries, of 4 % each, add three times a path of 1.5e-3.
    const double round = 0.0017 * std::exp(-2 * (0.6 + 0.1) / cosine);
    EXPECT_NEAR(paths.values[2].mean, 0.3 / cosine * (1 + 2 * round), 1e-4);
    EXPECT_NEAR(paths.values[3].mean, 0.2 / cosine * (1 + 2 * round), 1e-4);
    EXPECT_NEAR(paths.values[0].mean, 2 * 0.3 / cosine, 3e-3);  // reflected below both
}

/// One layer of one index: the mean time of flight is n times the mean path over c.
TEST(MeanPath, IsTheTimeOfFlightOfPhotons)
{
    constexpr double cm_per_ps = 0.0299792458;
    constexpr std::uint64_t photons = 400'000;
    constexpr std::size_t bins = 2000;
    const LayeredMedium medium = in_air({layer(1.4, 1, 50, 0.5, 0.2)});
    const ExactValues paths = exact_values(job(medium, "mean_path"), {});
    PhotonRequest request = photon_request(photons);
    request.tallies = {.reflected = true,
                       .transmitted = true,
                       .row = ExitRow::time,
                       .time_width = 0.2,
                       .rows = bins};
    const PhotonResult result = simulate_photons(medium, request, photons);
    ZTest test;
    const auto add = [&](const char* name, const std::vector<Fraction>& tally, double path) {
        double sum = 0, time = 0, squares = 0;
        for (std::size_t k = 0; k < bins; ++k) {
            const double t = (double(k) + 0.5) * 0.2;
            sum += tally[k].mean;
            time += tally[k].mean * t;
            squares += tally[k].mean * t * t;
        }
        const double mean = time / sum;
        // Photons weigh 1 at most: no more noise than that of as many whole ones.
        const double error = std::sqrt((squares / sum - mean * mean) / (sum * double(photons)));
        test.add(name, {mean, error}, path * 1.4 / cm_per_ps, photons);
    };
    add("reflected", result.reflected, paths.values[0].mean);
    add("transmitted", result.transmitted, paths.values[1].mean);
    test.expect_only_noise();
}

/// Means over the bins: the exact BRDF at the nodes of a rule in each.
TEST(PhotonBrdf, IsTheExactOne)
{
    constexpr std::size_t angles = 6, rows = 6, nodes = 5;
    constexpr std::uint64_t photons = 400'000;
    const LayeredMedium medium = in_air({layer(1.4, 1, 40, 0.6, 0.1), layer(1.3, 2, 20, 0, 0.1)});
    PhotonRequest request = photon_request(photons, {.incidence = radians(50)});
    request.tallies = {.reflected = true, .row = ExitRow::azimuth, .rows = rows, .angles = angles};
    const PhotonResult result = simulate_photons(medium, request, photons);
    const std::vector<Axis> axes = {{"theta_i", "deg", {50}},
                                    even_axis("theta_o", 90, angles),
                                    even_axis("delta_phi", 180, rows)};
    const auto found =
        densities(result, find_quantity("brdf", Substance::layers), request.tallies, axes);
    const auto fine = [&](std::size_t cells, double range) {
        std::vector<double> all;
        for (std::size_t k = 0; k < cells * nodes; ++k)
            all.push_back(range * (double(k) + 0.5) / double(cells * nodes));
        return all;
    };
    const auto exact =
        reference::layered_brdf(medium, {radians(50)}, fine(angles, pi / 2), fine(rows, pi), 34);
    ZTest test;
    for (std::size_t a = 0; a < angles; ++a)
        for (std::size_t r = 0; r < rows; ++r) {
            double sum = 0, weight = 0;
            for (std::size_t k = 0; k < nodes; ++k) {
                const std::size_t out = a * nodes + k;
                const double theta = pi / 2 * (double(out) + 0.5) / double(angles * nodes);
                const double cosines = std::sin(2 * theta);
                for (std::size_t m = 0; m < nodes; ++m) {
                    // delta_phi counts from where light comes, the reference from the mirror's side
                    const std::size_t azimuth = rows * nodes - 1 - (r * nodes + m);
                    sum += cosines * exact.values[out * rows * nodes + azimuth];
                    weight += cosines;
                }
            }
            test.add("cell " + std::to_string(a) + ", " + std::to_string(r),
                     estimate(found[a * rows + r]), sum / weight, photons);
        }
    test.expect_only_noise();
}

}  // namespace
}  // namespace gonio::test

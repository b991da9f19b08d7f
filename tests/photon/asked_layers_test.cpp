// SPDX-License-Identifier: Apache-2.0
// Layers that a table does not need are left out, and its values stay within their errors.
#include "photon/asked_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "photon/bins.hpp"
#include "photon/exact_values.hpp"
#include "photon/photon_fixtures.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

Job job_of(const LayeredMedium& medium, std::string_view quantity, std::optional<double> max_error)
{
    Job job;
    job.layers =
        LightJob{medium, &find_quantity(quantity, Substance::layers), "adding_doubling", {}, 1, {}};
    job.layers->budget.max_error = max_error;
    if (quantity == "directional_albedo") job.header.axes = {{"mu", "1", {0.2, 0.6, 1}}};
    if (quantity == "mean_albedo") job.layers->light.beam = Beam::diffuse;
    if (quantity == "reflectance_alpha")
        job.header.axes = {make_axis("alpha", 0, 90, 6, Samples::centre)};
    if (quantity.starts_with("reflectance_r") || quantity == "reflectance_t")
        job.header.axes = {
            make_axis(quantity == "reflectance_t" ? "t" : "r", 0, 1, 10, Samples::centre)};
    return job;
}

/// With an absorption of 20/cm no more than exp(-10) of the light comes through the first layer.
LayeredMedium dark_over_bright(double dark_mua)
{
    return in_air(
        {layer(1.4, dark_mua, 20, 0.5, 0.5), layer(1.4, 0, 100, 0, 0.2), layer(1.5, 0.1, 0, 0, 1)});
}

TEST(AskedLayers, GoWhereNothingReachesThem)
{
    const AskedLayers asked = asked_layers(job_of(dark_over_bright(20), "mean_albedo", 1e-3));
    EXPECT_EQ(asked.unreached, 2U);
    EXPECT_EQ(asked.medium.layers.size(), 1U);
    EXPECT_EQ(asked.medium.layers[0].d, infinite);
    EXPECT_GT(asked.returned, 0);
    EXPECT_LT(asked.returned, 1e-4);
    const auto kept = [](const Job& job) { return asked_layers(job).unreached == 0; };
    EXPECT_TRUE(kept(job_of(dark_over_bright(20), "mean_albedo", {})));
    EXPECT_TRUE(kept(job_of(dark_over_bright(20), "light_budget", 1e-3)));
    EXPECT_TRUE(kept(job_of(dark_over_bright(20), "mean_path", 1e-3)));
    EXPECT_TRUE(kept(job_of(dark_over_bright(20), "transmittance_alpha", 1e-3)));
    EXPECT_TRUE(kept(job_of(dark_over_bright(1), "mean_albedo", 1e-3)));
    EXPECT_TRUE(kept(job_of(dark_over_bright(0), "mean_albedo", 1e-3)));
}

TEST(AskedLayers, GoWhereTheyOnlyPassLightOn)
{
    const LayeredMedium medium =
        in_air({layer(1, 0, 0, 0, 0.1), layer(1.4, 1, 10, 0, 0.1), layer(1.4, 0, 0, 0, 0.1),
                layer(1.5, 0, 0, 0, 0.1), layer(1.3, 1, 10, 0, 0.1), layer(1, 0, 0, 0, 0.1)});
    const AskedLayers asked = asked_layers(job_of(medium, "directional_albedo", {}));
    EXPECT_EQ(asked.clear, 3U);
    ASSERT_EQ(asked.medium.layers.size(), 3U);
    EXPECT_EQ(asked.medium.layers[1].n, 1.5);  // a pane, whose surfaces reflect
    EXPECT_EQ(asked_layers(job_of(medium, "light_budget", {})).clear, 0U);
    EXPECT_EQ(asked_layers(job_of(medium, "reflectance_r", {})).clear, 0U);
    EXPECT_EQ(asked_layers(job_of(medium, "reflectance_t", {})).clear, 0U);
    LayeredMedium mirror = medium;
    mirror.bottom = Bottom::mirror;
    EXPECT_EQ(asked_layers(job_of(mirror, "directional_albedo", {})).clear, 2U);
}

class Stacks {
public:
    LayeredMedium next()
    {
        LayeredMedium medium;
        const std::size_t count = 2 + random_() % 4;
        for (std::size_t k = 0; k < count; ++k) {
            const double n = random_() % 2 == 0 ? 1.4 : 1.3 + 0.3 * even();
            const bool clear = random_() % 5 == 0;
            medium.layers.push_back(layer(n, clear ? 0 : 0.3 * std::pow(100, even()),
                                          clear ? 0 : 5 * std::pow(30, even()), 0.9 * even(),
                                          0.02 * std::pow(30, even())));
        }
        medium.bottom = random_() % 2 == 0 ? Bottom::open : Bottom::mirror;
        return medium;
    }

private:
    double even() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

    std::mt19937_64 random_{5};
};

TEST(AskedLayers, ChangeNothingByMoreThanTheError)
{
    Stacks stacks;
    std::size_t unreached = 0, clear = 0;
    for (int k = 0; k < 60; ++k) {
        const auto quantity = std::vector{"directional_albedo", "mean_albedo",
                                          "reflectance_alpha"}[static_cast<std::size_t>(k % 3)];
        const double error = k % 2 == 0 ? 1e-2 : 1e-3;
        const Job job = job_of(stacks.next(), quantity, error);
        const AskedLayers asked = asked_layers(job);
        unreached += asked.unreached;
        clear += asked.clear;
        if (asked.unreached + asked.clear == 0) continue;
        LightJob planned = *job.layers;
        planned.medium = asked.medium;
        const auto whole = exact_values(*job.layers, job.header.axes).values;
        const auto less = exact_values(planned, job.header.axes).values;
        const bool density = k % 3 == 2;
        double largest = density ? 0 : 1;
        for (const Fraction& value : whole) largest = std::max(largest, value.mean);
        for (std::size_t i = 0; i < whole.size(); ++i)
            EXPECT_NEAR(less[i].mean, whole[i].mean,
                        0.1 * error * largest + whole[i].error + less[i].error)
                << "stack " << k << ", value " << i;
    }
    EXPECT_GT(unreached, 10U);
    EXPECT_GT(clear, 5U);
}

/// The same photons, all but those that come deep.
TEST(AskedLayers, AreNotMissedByPhotons)
{
    const LayeredMedium medium =
        in_air({layer(1.4, 30, 50, 0.5, 1), layer(1.4, 0, 100, 0, 0.2), layer(1.5, 1, 9, 0, 1)});
    EXPECT_EQ(asked_layers(job_of(medium, "reflectance_t", 1e-2)).unreached, 2U);
    const Job job = job_of(medium, "reflectance_r", 1e-2);
    const AskedLayers asked = asked_layers(job);
    ASSERT_EQ(asked.unreached, 2U);
    const PhotonTallies tallies = tallies_of(*job.layers->quantity, job.header.axes);
    const auto values = [&](const LayeredMedium& of) {
        return densities(
            simulate_photons(of, {.tallies = tallies, .batch = 1024}, std::uint64_t{1} << 15),
            *job.layers->quantity, tallies, job.header.axes);
    };
    const auto whole = values(medium), less = values(asked.medium);
    for (std::size_t k = 0; k < whole.size(); ++k)
        EXPECT_NEAR(less[k].mean, whole[k].mean, 1e-3 * whole[0].mean) << k;
}

}  // namespace
}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// What gonio plan says of photons is about what comes.
#include "plan/photon_forecast.hpp"

#include <gtest/gtest.h>

#include "gonio/scene.hpp"
#include "photon/simulation.hpp"
#include "plan/batch.hpp"

namespace gonio::test {
namespace {

Job job_of(const std::string& budget)
{
    return plan_jobs(parse_scene("[[material]]\nname = \"a\"\nlayers = [ { mua = 1, mus = 90, g = "
                                 "0.75, n = 1.4, d = 0.1 } ]\n[[table]]\nmaterial = \"a\"\n"
                                 "quantity = \"reflectance_r\"\naxes = { r = { to = 0.5, count = "
                                 "5 } }\n" +
                                     budget,
                                 "forecast"))
        .front();
}

// Errors of errors: those of the largest bin by 8 batches and more are within a third of it, so
// that photons for an error are known to a factor of 2.
TEST(PhotonForecast, IsAboutWhatComes)
{
    const Device device;
    for (const std::string budget : {"photons = 1_000_000\n", "max_error = 1e-3\n"}) {
        const Job job = job_of(budget);
        const PhotonForecast expected = forecast(device, job);
        const LightTable found = simulate(device, job, [](const LightProgress&) {}).table;
        const auto photons = static_cast<double>(found.photons);
        EXPECT_GT(expected.photons, photons / 2) << budget;
        EXPECT_LT(expected.photons, photons * 2) << budget;
        EXPECT_NEAR(expected.error, found.error, found.error / 3) << budget;
    }
    EXPECT_EQ(forecast(device, job_of("photons = 1_000_000\n")).photons, 1e6);
}

TEST(PhotonForecast, EndsWithTheTime)
{
    const PhotonForecast expected = forecast(Device(), job_of("time = 5\nmax_error = 1e-9\n"));
    EXPECT_NEAR(expected.seconds, 5, 1e-9);
    EXPECT_GT(expected.error, 1e-9);
}

}  // namespace
}  // namespace gonio::test

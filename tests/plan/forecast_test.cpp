// SPDX-License-Identifier: Apache-2.0
// What gonio plan says of time and error is about what comes.
#include "plan/forecast.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "compute/make_table.hpp"
#include "compute/shared_device.hpp"
#include "gonio/scene.hpp"
#include "photon/exact_values.hpp"
#include "photon/simulation.hpp"
#include "plan/batch.hpp"
#include "plan/trial.hpp"
#include "quadrature/derived.hpp"
#include "skin/profile_table.hpp"

namespace gonio {
namespace {

using testing::AllOf;
using testing::Gt;
using testing::Lt;

class Forecasts : public test::SharedDevice {
protected:
    Job job_of(const std::string& material, const std::string& table) const
    {
        return plan_jobs(parse_scene("[[material]]\nname = \"a\"\n" + material +
                                         "\n[[table]]\nmaterial = \"a\"\n" + table,
                                     "s.toml"),
                         scratch.path())
            .front();
    }

    Forecast of(const Job& job) const { return forecast(*device(), job); }

    ScratchFolder scratch;
};

const std::string slab = "layers = [ { mua = 1, mus = 90, g = 0.75, n = 1.4, d = 0.1 } ]";
const std::string by_distance =
    "quantity = \"reflectance_r\"\naxes = { r = { to = 0.5, count = 5 } }\n";

// Errors of errors: those of the largest bin by 8 batches and more are within a third of it, so
// that photons for an error are known to a factor of 2.
TEST_F(Forecasts, OfPhotonsAreAboutWhatComes)
{
    for (const std::string budget : {"photons = 1_000_000\n", "max_error = 1e-3\n"}) {
        const Job job = job_of(slab, by_distance + budget);
        const Forecast expected = of(job);
        const LightTable found = simulate(*device(), job, [](const LightProgress&) {}).table;
        const auto photons = static_cast<double>(found.photons);
        EXPECT_THAT(expected.photons, AllOf(Gt(photons / 2), Lt(photons * 2))) << budget;
        EXPECT_NEAR(expected.error, found.error, found.error / 3) << budget;
        EXPECT_FALSE(expected.is_bound);
    }
    EXPECT_EQ(of(job_of(slab, by_distance + "photons = 1_000_000\n")).photons, 1e6);
}

TEST_F(Forecasts, OfPhotonsEndWithTheTime)
{
    const Forecast expected = of(job_of(slab, by_distance + "time = 5\nmax_error = 1e-9\n"));
    EXPECT_NEAR(expected.seconds, 5, 1e-9);
    EXPECT_GT(expected.error, 1e-9);
}

// Work that would take a second is left after a part of it, and its preparation counts once.
TEST_F(Forecasts, TryWorkForAWhile)
{
    using std::chrono::milliseconds;
    const Stopwatch since;
    const double seconds = seconds_by_trial([](const auto& after_part) {
        std::this_thread::sleep_for(milliseconds(150));
        for (double part = 0.01; part < 1; part += 0.01) {
            after_part(part);
            std::this_thread::sleep_for(milliseconds(20));
        }
    });
    EXPECT_LT(since.seconds(), 1.5);
    EXPECT_THAT(seconds, AllOf(Gt(2), Lt(4)));
    EXPECT_LT(seconds_by_trial([](const auto& after_part) { after_part(1); }), 0.1);
}

TEST_F(Forecasts, OfLayersWithoutNoiseKnowTheirErrorAndTime)
{
    const std::string grid =
        "quantity = \"brdf\"\ngrid = { kind = \"isotropic\", theta_i = 30, theta_o = 30, "
        "delta_phi = 30 }\n";
    const auto seconds_of = [](const Job& job) {
        const Stopwatch since;
        exact_values(*job.layers, job.header.axes);
        return since.seconds();
    };
    const Job job = job_of(slab, grid + "max_error = 1e-9\n");
    const Forecast expected = of(job);
    EXPECT_EQ(expected.error, 1e-9);
    EXPECT_TRUE(expected.is_bound);
    // On a slow machine the error of the first solutions comes after the trial.
    const double two = seconds_of(job_of(slab, grid + "time = 0\n")), seconds = seconds_of(job);
    const double factor = two < 0.5 ? 3 : 8;
    EXPECT_THAT(expected.seconds, AllOf(Gt(seconds / factor), Lt(seconds * factor)));

    const Forecast soon = of(job_of(slab, grid + fmt::format("time = {}\n", 4 * two)));
    const Forecast later = of(job_of(slab, grid + fmt::format("time = {}\n", 64 * two)));
    EXPECT_FALSE(later.is_bound);
    EXPECT_NEAR(later.seconds, 64 * two, 1e-3);
    EXPECT_THAT(later.error, AllOf(Gt(0), Lt(soon.error)));
    EXPECT_EQ(of(job_of(slab, grid + "time = 400\nmax_error = 1e-3\n")).error, 1e-3);
}

TEST_F(Forecasts, OfLayersWithoutNoiseKnowWhatTheyAreComputedTo)
{
    EXPECT_EQ(of(job_of(slab, "quantity = \"light_budget\"\n")).error, 1e-6);
    // Known when all is done, within the trial.
    const Forecast paths = of(job_of(slab, "quantity = \"mean_path\"\n"));
    EXPECT_THAT(paths.error, AllOf(Gt(1e-8), Lt(1e-4)));
    EXPECT_FALSE(paths.is_bound);
}

TEST_F(Forecasts, OfGridsAreBoundsThatHold)
{
    const std::string brdf =
        "quantity = \"brdf\"\ngrid = { kind = \"isotropic\", theta_i = 30, theta_o = 90, "
        "delta_phi = 360 }\n";
    const Job job = job_of("model = \"ggx\"", brdf);
    const Forecast expected = of(job);
    const MadeTable made = make_table(*device(), job, [](std::size_t) {});
    EXPECT_TRUE(expected.is_bound);
    EXPECT_LT(made.accuracy.relative, expected.error);
    EXPECT_GT(100 * made.accuracy.relative, expected.error);
    EXPECT_GT(expected.seconds, made.kernel_seconds / 4);
    EXPECT_LT(expected.seconds, 20);

    Job half = job;
    half.write.half = true;
    EXPECT_GT(of(half).error, 4e-4);
    const Job sweep = job_of(
        "model = \"ggx\"\nparameters = { alpha = { from = 0.1, to = 0.9, "
        "count = 20 } }",
        brdf);
    EXPECT_THAT(of(sweep).seconds / expected.seconds, AllOf(Gt(5), Lt(80)));
}

TEST_F(Forecasts, OfIntegralsAreOfAllTheirCells)
{
    const auto albedo = [&](const std::string& rest) {
        return job_of("model = \"ward\"\nparameters = { alpha = 0.02 }",
                      "quantity = \"directional_albedo\"\naxes = { mu = { from = 0.02, to = 1, "
                      "count = 20_000 } }\n" +
                          rest);
    };
    const Job job = albedo("max_error = 1e-5\n");
    const Forecast expected = of(job);
    EXPECT_TRUE(expected.is_bound);
    EXPECT_EQ(expected.error, 1e-5);
    const Stopwatch since;
    const DerivedTable found = derive(*device(), job);
    const double seconds = since.seconds();
    EXPECT_LE(found.largest_error, expected.error);
    EXPECT_THAT(expected.seconds, AllOf(Gt(seconds / 4), Lt(seconds * 4)));
    EXPECT_FALSE(of(albedo("time = 1e-3\n")).is_bound);
}

TEST_F(Forecasts, OfLightThatSpreadsInSkinAreAboutWhatComes)
{
    const auto table = [&](const std::string& rest) {
        return job_of("skin = \"meglinski_2002\"\nparameters = { melanin = 0.03 }",
                      "quantity = \"reflectance_r\"\naxes = { wavelength = { from = 450, to = 700, "
                      "count = 11 }, r = { to = 0.05, count = 10 } }\n" +
                          rest);
    };
    const auto run = [&](const Job& job) {
        return make_profile_table(*device(), job, [](double) {});
    };
    const Job fixed = table("photons = 300_000\n");
    const Forecast of_fixed = of(fixed);
    const std::vector<double> errors = run(fixed)["spectra"][0]["error_of_largest_value"];
    EXPECT_EQ(of_fixed.photons, 3e5);
    EXPECT_NEAR(of_fixed.error, std::ranges::max(errors), std::ranges::max(errors) / 2);

    const Job exact = table("max_error = 4e-3\n");
    const Forecast of_exact = of(exact);
    const double photons = run(exact)["photons"];
    EXPECT_EQ(of_exact.error, 4e-3);
    EXPECT_THAT(of_exact.photons, AllOf(Gt(photons / 3), Lt(photons * 3)));

    const Forecast in_time = of(table("time = 30\nmax_error = 1e-9\n"));
    EXPECT_NEAR(in_time.seconds, 30, 1);
    EXPECT_GT(in_time.error, 1e-9);
}

TEST_F(Forecasts, KnowWhatIsAsked)
{
    const std::string mean = "quantity = \"mean_albedo\"\n";
    EXPECT_EQ(asked_error(job_of(slab, mean)), std::nullopt);
    EXPECT_EQ(asked_error(job_of(slab, mean + "max_error = 1e-4\n")), 1e-4);
    EXPECT_EQ(asked_error(job_of("model = \"ggx\"", mean)), std::nullopt);
    EXPECT_EQ(asked_error(job_of("model = \"ggx\"", mean + "max_error = 1e-4\n")), 1e-4);
    const std::string skin = "skin = \"meglinski_2002\"";
    EXPECT_EQ(asked_error(job_of(skin, "quantity = \"colour_rgb\"\nmax_error = 1e-3\n")), 1e-3);
    const std::string profile =
        "quantity = \"reflectance_r\"\naxes = { wavelength = { values = [500] }, r = { to = 0.1, "
        "count = 2 } }\n";
    EXPECT_EQ(asked_error(job_of(skin, profile + "ring_error = 0.3\n")), 0.3);
}

// Where next to no light comes nobody can tell how long it takes to see it.
TEST_F(Forecasts, SayWhereTheyKnowNothing)
{
    const Forecast dark = of(job_of("skin = \"meglinski_2002\"",
                                    "quantity = \"reflectance_r\"\naxes = { wavelength = { values "
                                    "= [400] }, r = { to = 2, count = 10 } }\nring_error = 0.1\n"));
    EXPECT_TRUE(std::isnan(dark.seconds));
    EXPECT_TRUE(std::isnan(dark.error));
    const Forecast deep = of(job_of("layers = [ { mua = 900, mus = 100, n = 1.4, d = 1 } ]",
                                    "quantity = \"transmittance_r\"\naxes = { r = { to = 1, count "
                                    "= 4 } }\nmax_error = 0.01\n"));
    EXPECT_TRUE(std::isnan(deep.seconds));
}

TEST_F(Forecasts, CostNothingWhereNothingIsMade)
{
    const Job job = job_of("model = \"ggx\"",
                           "quantity = \"brdf\"\ngrid = { kind = \"isotropic\", theta_i = 5, "
                           "theta_o = 5, delta_phi = 5 }\n");
    Job twin = job;
    twin.path += ".other";
    make_table(*device(), job, [](std::size_t) {});
    const std::vector<Forecast> all = forecasts(*device(), {job, twin});
    EXPECT_EQ(all[0].seconds, 0);
    EXPECT_EQ(all[1].seconds, 0);
    std::filesystem::remove(job.path);
    EXPECT_GT(forecasts(*device(), {job, twin})[0].seconds, 0);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Tables of layers: from a scene to a file, with its solver, its budget and its errors.
#include "photon/light_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "gonio/errors.hpp"
#include "photon/bins.hpp"
#include "plan/batch.hpp"

namespace gonio::test {
namespace {

const std::string slab =
    "[output]\nformat = \"csv\"\n[[material]]\nname = \"slab\"\n"
    "layers = [ { mua = 10, mus = 90, g = 0.75, d = 0.02 } ]\n[[table]]\nmaterial = \"slab\"\n";

/// In a directory that the test cleans up.
class LightTables : public testing::Test {
protected:
    LightTables() { std::filesystem::create_directories(directory); }
    ~LightTables() override { std::filesystem::remove_all(directory); }

    Job job(const std::string& lines) const
    {
        return plan_jobs(parse_scene(slab + lines, "scene.toml"), directory).front();
    }
    static LightTable make(const Job& job)
    {
        return make_light_table(Device(), job, [](const LightProgress&) {});
    }

    std::filesystem::path directory = std::filesystem::temp_directory_path() / "gonio-light-tables";
};

TEST_F(LightTables, HoldTheBudgetWithoutNoise)
{
    const Job exact = job("quantity = \"light_budget\"\n");
    EXPECT_EQ(make(exact).photons, 0U);
    const Table table = read_table(exact.path);
    ASSERT_EQ(table.header.channels.size(), 12U);
    EXPECT_EQ(table.header.channels[1], "diffuse_reflectance");
    EXPECT_NEAR(table.values[1][0], 0.09739464, 1e-6);  // van de Hulst 1980: 0.09739
    EXPECT_EQ(table.header.channels[7], "diffuse_reflectance.error");
    EXPECT_TRUE(is_finished(exact));
}

TEST_F(LightTables, AgreeBetweenSolvers)
{
    const Job noisy = job("quantity = \"light_budget\"\nsolver = \"monte_carlo\"\nphotons = 1e6\n");
    EXPECT_EQ(make(noisy).photons, 1'000'000U);
    const Table table = read_table(noisy.path);
    EXPECT_NEAR(table.values[1][0], 0.09739464, 5 * table.values[7][0]);
    EXPECT_GT(table.values[7][0], 1e-4);
    EXPECT_LT(table.values[7][0], 5e-4);
    EXPECT_TRUE(is_finished(noisy));
}

TEST_F(LightTables, IntegrateToTheTotals)
{
    const Job radii =
        job("quantity = \"reflectance_r_alpha\"\nphotons = 1e5\n"
            "axes = { r = { to = 1, count = 20 }, alpha = { to = 90, count = 6 } }\n");
    const double beyond = make(radii).run["beyond_the_bins"];
    const Table table = read_table(radii.path);
    double sum = beyond;
    for (std::size_t k = 0; k < table.values[0].size(); ++k)
        sum += table.values[0][k] * ring_area(k / 6, 0.05) * solid_angle(k % 6, 6);
    EXPECT_NEAR(sum, 0.09739464, 5e-3);
    const Job depths = job(
        "quantity = \"absorption_z\"\nphotons = 1e5\naxes = { z = { to = 0.02, count = 10 } }\n");
    make(depths);
    double absorbed = 0;
    const Table densities = read_table(depths.path);
    for (const double density : densities.values[0]) absorbed += density * 0.002;
    EXPECT_NEAR(absorbed, 0.24164766, 5e-3);
}

TEST_F(LightTables, StopAtTheirBudget)
{
    const std::string bins =
        "quantity = \"reflectance_alpha\"\nsolver = \"monte_carlo\"\n"
        "axes = { alpha = { to = 90, count = 3 } }\n";
    Job missed = job(bins + "max_error = 1e-5\nphotons = 1e4\n");
    EXPECT_THROW(make(missed), RunError);
    EXPECT_FALSE(std::filesystem::exists(missed.path));
    missed.must_reach = false;
    EXPECT_GT(make(missed).error, 1e-5);
    const LightTable exact = make(job(bins + "max_error = 0.01\n"));
    EXPECT_LE(exact.error, 0.01);
    EXPECT_GE(exact.photons, 32U * 1024U);  // few batches do not tell their error
    EXPECT_GT(make(job(bins + "time = \"0.1 s\"\n")).photons, 0U);
}

/// So dark that no photon comes through: nothing tells how exact zeros are.
TEST_F(LightTables, SayWhereNoLightHasCome)
{
    const std::string dark =
        "quantity = \"transmittance_r\"\naxes = { r = { to = 0.5, count = 4 } }\n";
    const auto of = [&](const std::string& budget) {
        return plan_jobs(parse_scene("[[material]]\nname = \"dark\"\nlayers = [ { mua = 900, mus = "
                                     "100, g = 0.5, n = 1.4, d = 1 } ]\n[[table]]\nmaterial = "
                                     "\"dark\"\n" +
                                         dark + budget,
                                     "s.toml"),
                         testing::TempDir())
            .front();
    };
    EXPECT_TRUE(std::isinf(make(of("photons = 4096\n")).error));
    Job endless = of("max_error = 0.01\n");
    std::filesystem::remove(endless.path);
    EXPECT_THROW(make(endless), RunError);
    EXPECT_FALSE(std::filesystem::exists(endless.path));
    endless.must_reach = false;
    EXPECT_EQ(make(endless).photons, 1U << 24);
}

/// As many nodes as there is time for, with the error that they have.
TEST_F(LightTables, StopAtTheirTimeWithoutNoise)
{
    const std::string budget = "quantity = \"light_budget\"\n";
    for (const std::string& quantity :
         {budget,
          std::string("quantity = \"brdf\"\ngrid = { kind = \"isotropic\", theta_i = 2, theta_o = "
                      "2, delta_phi = 2 }\n"),
          std::string("quantity = \"reflectance_alpha\"\naxes = { alpha = { to = 90, count = 3 } "
                      "}\n")}) {
        SCOPED_TRACE(quantity);
        const LightTable rough = make(job(quantity + "time = 0\n"));
        EXPECT_EQ(rough.run["nodes"], 24);
        Job missed = job(quantity + "max_error = 1e-13\ntime = 0\n");
        std::filesystem::remove(missed.path);
        EXPECT_THROW(make(missed), RunError);
        EXPECT_FALSE(std::filesystem::exists(missed.path));
        missed.must_reach = false;
        EXPECT_EQ(make(missed).error, rough.error);
    }
    const Job timed = job(budget + "time = \"0.5 s\"\n");
    EXPECT_GT(make(timed).run["nodes"], 24);
    EXPECT_TRUE(is_finished(timed));
    const Table table = read_table(timed.path);
    EXPECT_NEAR(table.values[1][0], 0.09739464, 1e-8);
    EXPECT_LT(table.values[7][0], 1e-7);
}

std::string bytes_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Interrupted after each launch, over and over; a broken checkpoint is no checkpoint.
TEST_F(LightTables, GoOnToTheSameBytes)
{
    const Job whole =
        job("quantity = \"brdf\"\nsolver = \"monte_carlo\"\nphotons = 1e6\n"
            "grid = { kind = \"isotropic\", theta_i = 3, theta_o = 3, delta_phi = 4 }\n");
    make(whole);
    const std::string expected = bytes_of(whole.path),
                      checkpoint = whole.path.string() + ".checkpoint";
    std::filesystem::remove(whole.path);
    std::ofstream(checkpoint) << "broken";
    int interruptions = 0;
    for (bool finished = false; !finished;) {
        int launches = 0;
        try {
            make_light_table(Device(), whole, [&](const LightProgress&) {
                if (++launches == (interruptions < 3 ? 2 : 40))
                    throw std::runtime_error("interrupted");
            });
            finished = true;
        } catch (const std::runtime_error&) {
            ++interruptions;
            EXPECT_TRUE(std::filesystem::exists(checkpoint));
        }
    }
    EXPECT_GT(interruptions, 2);
    EXPECT_EQ(bytes_of(whole.path), expected);
    EXPECT_FALSE(std::filesystem::exists(checkpoint));
}

TEST(LightBins, CoverTheHemisphereAndTheDisc)
{
    double sphere = 0, disc = 0;
    for (std::size_t k = 0; k < 30; ++k) {
        sphere += solid_angle(k, 30);
        disc += ring_area(k, 0.1);
    }
    EXPECT_NEAR(sphere, 2 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(disc, 9 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace gonio::test

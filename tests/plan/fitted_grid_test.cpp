// SPDX-License-Identifier: Apache-2.0
// Grids that are as fine as an error asks for: tables on them, read back where nobody looked.
#include "plan/fitted_grid.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "compute/make_table.hpp"
#include "compute/shared_device.hpp"
#include "gonio/errors.hpp"
#include "output/grid_coordinates.hpp"
#include "output/lookup.hpp"

namespace gonio {
namespace {

class FittedGrid : public test::SharedDevice {};

struct Case {
    const char *model, *parameters, *grid;
    double max_error;
};

Job job_of(const Case& which)
{
    return plan_jobs(
               parse_scene(fmt::format("[[material]]\nname = \"m\"\nmodel = \"{}\"\n"
                                       "[material.parameters]\n{}\n[[table]]\n"
                                       "material = \"m\"\nquantity = \"brdf\"\n"
                                       "grid = {{ {} }}\nmax_error = {}\n",
                                       which.model, which.parameters, which.grid, which.max_error),
                           "s.toml"),
               testing::TempDir())
        .front();
}

/// Of all pairs but those at which the grid was fitted: the largest error, over the largest value.
double largest_error(const Job& job, const Table& table, bool cubic)
{
    const Reference f = make_reference(job.materials.front(), job.measure);
    const Lookup lookup(table, cubic ? Interpolation::cubic : Interpolation::linear);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> theta(0, fitted_theta), phi(0, 360), near(-6, 6);
    double worst = 0, peak = 0;
    for (int k = 0; k < 10'000; ++k) {
        DirectionPair pair{theta(random), phi(random), theta(random), phi(random)};
        if (k % 2 == 0) {
            pair.theta_o = std::clamp(pair.theta_i + near(random), 0.0, fitted_theta);
            pair.phi_o = std::fmod(pair.phi_i + 540 + near(random), 360);
        }
        const auto [l, v] = unit_vectors(pair);
        const double right = f(l, v, 0);
        const double found = lookup.at(grid_coordinates(job.grid.kind, pair))[0];
        worst = std::max(worst, std::abs(found - right));
        peak = std::max(peak, right);
    }
    return worst / peak;
}

TEST_F(FittedGrid, KeepsToTheErrorEverywhere)
{
    const std::string round = "kind = \"isotropic\", delta_phi_to = 180, samples = \"node\"";
    const std::string cubic = round + ", interpolation = \"cubic\"";
    for (const Case& which :
         {Case{"lambert", "rho = 0.5", "kind = \"isotropic\"", 1e-4},
          Case{"ggx", "alpha = 0.3", round.c_str(), 4e-2},
          Case{"ggx", "alpha = 0.3", cubic.c_str(), 2e-2},
          Case{"blinn_phong", "exponent = 10", "kind = \"isotropic\"", 4e-2},
          Case{"cook_torrance", "m = 0.3", "kind = \"rusinkiewicz\", spacing = \"merl\"", 5e-2},
          Case{"oren_nayar", "sigma = 20", cubic.c_str(), 1e-2}}) {
        SCOPED_TRACE(fmt::format("{} {} {}", which.model, which.parameters, which.grid));
        const Job job = job_of(which);
        EXPECT_LE(job.interpolation_error, which.max_error);
        const Table values = compute_table(*device(), job.materials.front(), job.measure, job.grid);
        const double found =
            largest_error(job, values, std::string(which.grid).find("cubic") != std::string::npos);
        EXPECT_LE(found, 1.1 * which.max_error);
    }
}

TEST_F(FittedGrid, IsFinerForLessErrorAndCoarserForCubic)
{
    const std::string linear = "kind = \"isotropic\", delta_phi_to = 180, samples = \"node\"";
    const std::string cubic = linear + ", interpolation = \"cubic\"";
    const auto cells = [](const std::string& grid, double error) {
        return job_of({"ggx", "alpha = 0.4", grid.c_str(), error}).header.cells();
    };
    EXPECT_GT(cells(linear, 1e-2), 2 * cells(linear, 4e-2));
    EXPECT_GT(cells(linear, 1e-2), 2 * cells(cubic, 1e-2));
}

TEST_F(FittedGrid, IsSaidInTheHeader)
{
    const Job job = job_of({"ggx", "alpha = 0.5", "kind = \"isotropic\"", 5e-2});
    EXPECT_EQ(std::get<std::string>(*job.header.find("interpolation")),
              "linear, to 85 deg from the normal");
    EXPECT_EQ(std::get<double>(*job.header.find("interpolation.max_error")), 5e-2);
    EXPECT_EQ(std::get<double>(*job.header.find("interpolation.error")), job.interpolation_error);
}

TEST_F(FittedGrid, TellsWhatCannotBeReached)
{
    const Job job = job_of({"ggx", "alpha = 1e-4", "kind = \"isotropic\"", 1e-3});
    EXPECT_GT(job.interpolation_error, 0.1);
    try {
        make_table(*device(), job, [](std::size_t) {});
        FAIL() << "the table was made";
    } catch (const RunError& error) {
        EXPECT_TRUE(std::string(error.what()).find("--best-effort") != std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Tables that have a time instead of a size: it is kept, about, and the error that they tell is
// right.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "compute/make_table.hpp"
#include "compute/shared_device.hpp"
#include "gonio/errors.hpp"
#include "plan/batch.hpp"
#include "plan/fitted_grid.hpp"
#include "plan/table_cost.hpp"
#include "plan/timed_grid.hpp"
#include "quadrature/derived.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

class TimeBudget : public test::SharedDevice {
protected:
    ~TimeBudget() override { std::filesystem::remove_all(directory); }

    std::vector<Job> jobs(const std::string& material, const std::string& table) const
    {
        return plan_jobs(parse_scene("[[material]]\nname = \"m\"\n" + material +
                                         "\n[[table]]\nmaterial = \"m\"\n" + table,
                                     "s.toml"),
                         directory);
    }

    /// On a grid that is chosen by time.
    Job timed(const std::string& budget) const
    {
        std::vector<Job> all =
            jobs("model = \"ggx\"\nparameters = { alpha = 0.4 }",
                 "quantity = \"brdf\"\ngrid = { kind = \"isotropic\", samples = \"node\", "
                 "delta_phi_to = 180 }\n" +
                     budget);
        fit_to_time(*device(), all);
        return all.front();
    }

    std::filesystem::path directory = std::filesystem::temp_directory_path() / "gonio-time-budgets";
};

/// Longer than this is no matter of a busy machine.
constexpr double patience = 20;

TEST_F(TimeBudget, OfIntegralsIsKeptAndTheirErrorIsRight)
{
    const std::string ggx = "model = \"ggx\"\nparameters = { alpha = 0.05 }";
    const std::string sum =
        "lobes = [ { model = \"phong\" }, { model = \"oren_nayar\" }, { model = \"ward\" } ]";
    const std::string mu = "axes = { mu = { from = 0.02, to = 1, count = 16 } }\n";
    for (const auto& [material, quantity] :
         {std::pair{ggx, "quantity = \"directional_albedo\"\n" + mu},
          {sum, "quantity = \"directional_albedo\"\n" + mu},
          {ggx, "quantity = \"dfg\"\n" + mu},
          {ggx, std::string("quantity = \"mean_albedo\"\n")}}) {
        SCOPED_TRACE(material + quantity);
        const DerivedTable right =
            derive(*device(), jobs(material, quantity + "max_error = 1e-6\n").front());
        double before = INFINITY;
        for (const double seconds : {1e-4, 0.3}) {
            const Job job = jobs(material, quantity + fmt::format("time = {}\n", seconds)).front();
            EXPECT_FALSE(job.must_reach);
            const Stopwatch since;
            const DerivedTable found = derive(*device(), job);
            EXPECT_LT(since.seconds(), patience * (0.05 + seconds));
            for (std::size_t c = 0; c < found.values.size() / 2; ++c)
                for (std::size_t k = 0; k < job.cells.size(); ++k)
                    EXPECT_NEAR(found.values[c][k], right.values[c][k],
                                found.values[c + found.values.size() / 2][k] +
                                    right.values[c + found.values.size() / 2][k]);
            EXPECT_LE(found.largest_error, before);
            before = found.largest_error;
        }
    }
}

TEST_F(TimeBudget, OfIntegralsMayNotBeEnough)
{
    const std::vector<Job> asked =
        jobs("model = \"ggx\"\nparameters = { alpha = 0.3 }",
             "quantity = \"directional_albedo\"\nmax_error = 1e-7\ntime = 1e-6\n"
             "axes = { mu = { to = 1, count = 4 } }\n");
    std::filesystem::create_directories(directory);
    try {
        make_table(*device(), asked.front(), [](std::size_t) {});
        FAIL() << "the table was made";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), HasSubstr("at the highest order for which 1e-06 s are enough; "
                                            "asked for is 1e-07"));
    }
    EXPECT_FALSE(std::filesystem::exists(asked.front().path));
}

TEST_F(TimeBudget, OfGridsIsKeptAndTheirErrorIsRight)
{
    std::size_t before = 0;
    for (const double seconds : {0.05, 0.5}) {
        const Job job = timed(fmt::format("time = {}\n", seconds));
        EXPECT_GT(job.header.cells(), before);
        before = job.header.cells();
        EXPECT_EQ(std::get<double>(*job.header.find("interpolation.error")),
                  job.interpolation_error);
        EXPECT_EQ(GridFitter(job, *job.fit)
                      .error({job.grid.axes[0].values.size(), job.grid.axes[1].values.size(),
                              job.grid.axes[2].values.size()}),
                  job.interpolation_error);
        const Stopwatch since;
        make_table(*device(), job, [](std::size_t) {});
        EXPECT_LT(since.seconds(), patience * seconds);
        for (const auto& entry : std::filesystem::directory_iterator(directory))
            EXPECT_EQ(entry.path(), job.path);  // no pilots
        // What an earlier run has chosen stays.
        const Job again = timed(fmt::format("time = {}\n", seconds));
        EXPECT_TRUE(is_finished(again));
        EXPECT_FALSE(again.fit);
        EXPECT_EQ(again.header.cells(), before);
    }
    EXPECT_GT(before, 100'000U);
}

// Of that time what every table takes is apart, and what only small ones do, all of whose values
// are compared with the reference.
TEST(TableCost, IsRightForTablesOfOtherSizes)
{
    constexpr double small = 0.1, cell = 1e-6, value = 3e-7, channels = 3;
    const auto taken = [&](double cells) {
        const double checking =
            value * double(AccuracyCheck::compared(static_cast<std::size_t>(channels * cells)));
        return TableSeconds{small + cell * cells + checking, checking};
    };
    for (const double seen : {2e4, 1e6}) {
        const TableCost cost(small, taken(seen), seen, channels);
        for (const double cells : {1e3, 1e5, 3e5, 1e7})
            EXPECT_NEAR(cost.cells_in(taken(cells).all), cells, 1e-6 * cells) << seen;
        EXPECT_EQ(cost.cells_in(small / 2), 0);
    }
}

TEST_F(TimeBudget, OfGridsEndsWhereTheErrorIsReached)
{
    const Job enough = timed("max_error = 0.2\ntime = 10\n");
    EXPECT_LE(enough.interpolation_error, 0.2);
    EXPECT_LT(enough.header.cells(), 20'000U);
    const Job missed = timed("max_error = 1e-6\ntime = 0.01\n");
    try {
        make_table(*device(), missed, [](std::size_t) {});
        FAIL() << "the table was made";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), HasSubstr("cells, as many as 0.01 s are enough for, "
                                            "interpolation is off by "));
        EXPECT_THAT(error.what(), HasSubstr("--best-effort"));
    }
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Sizes that --dry-run prints.
#include "plan/estimate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "output/table_fixtures.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

Job planned(const std::string& output, const std::string& grid)
{
    const auto text = test::SceneText{.output = output,
                                      .material =
                                          "name = \"steel\"\nmodel = \"ward\"\n"
                                          "parameters = { rho_s = [1, 1, 1] }",
                                      .grid = "kind = \"isotropic\", " + grid}
                          .text();
    return plan_jobs(parse_scene(text, "scene.toml")).front();
}

const std::string small = "theta_i = 10, theta_o = 20, delta_phi = 30";
const std::string large = "theta_i = 1000, theta_o = 1000, delta_phi = 1000";

TEST(Estimate, CountsValuesAndBytes)
{
    const TableSize size = size_of(planned("", small));
    EXPECT_EQ(size.values, 18000U);
    EXPECT_EQ(size.file_bytes, 72000U);
    EXPECT_EQ(size.memory_bytes, 72000U);
}

TEST(Estimate, KnowsTheFormats)
{
    EXPECT_EQ(size_of(planned("precision = \"half\"", small)).file_bytes, 36000U);
    EXPECT_EQ(size_of(planned("format = \"npy\"", small)).file_bytes, 72000U);
    EXPECT_EQ(size_of(planned("format = \"csv\"", small)).file_bytes, 432000U);
}

TEST(Estimate, BoundsTheMemoryOfALargeTable)
{
    EXPECT_EQ(size_of(planned("", large)).memory_bytes, std::uint64_t{128} << 20);
}

TEST(Estimate, IsALineForEachJobAndTheSum)
{
    const std::vector<Job> jobs{planned("", small), planned("format = \"npy\"", large)};
    const auto text = estimate_text(jobs, {{.seconds = 0.01}, {.seconds = 200}});
    EXPECT_EQ(std::ranges::count(text, '\n'), 3);
    EXPECT_THAT(text, HasSubstr("tables/steel-brdf.exr"));
    EXPECT_THAT(text, HasSubstr("10 x 20 x 30 x R,G,B"));
    EXPECT_THAT(text, HasSubstr("70.3 KiB on disk"));
    EXPECT_THAT(text, HasSubstr("11.2 GiB on disk"));
    EXPECT_THAT(text, HasSubstr("128 MiB in memory"));
    EXPECT_THAT(text, HasSubstr("below 0.1 s"));
    EXPECT_THAT(text, HasSubstr("3 min"));
    EXPECT_THAT(text, HasSubstr("2 tables"));
}

TEST(CheckDisk, AddsUpWhatGoesToOnePlace)
{
    const test::TemporaryDirectory place;
    const auto available = static_cast<double>(std::filesystem::space(place.path()).available);
    Job job = planned("format = \"npy\"", large);
    job.path = place / "table.npy";
    const double size = static_cast<double>(size_of(job).file_bytes);
    const auto fitting = static_cast<std::size_t>(0.9 * available / size);
    EXPECT_NO_THROW(check_disk(std::vector(fitting, job)));
    EXPECT_THROW(check_disk(std::vector(2 * fitting + 2, job)), UsageError);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Batches are resumed: what is finished is kept, what is not is made anew.
#include "plan/batch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "gonio/errors.hpp"
#include "output/sidecar.hpp"
#include "output/table_fixtures.hpp"
#include "plan/interrupt.hpp"

namespace gonio {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string scene_text(const std::string& format)
{
    return "[output]\nformat = \"" + format + "\"\n" + R"([[material]]
name = "steel"
model = "ward"
parameters = { alpha = { values = [0.1, 0.2, 0.3], as = "files" }, rho_s = 0.5 }
[[table]]
material = "steel"
quantity = "brdf"
grid = { kind = "isotropic", theta_i = 4, theta_o = 3, delta_phi = 2 }
)";
}

class Batch : public testing::TestWithParam<std::string> {
protected:
    test::TemporaryDirectory place;
    std::filesystem::path tables = place / "deep" / "tables";
    std::vector<Job> jobs = plan_jobs(parse_scene(scene_text(GetParam()), "scene.toml"), tables);
    std::vector<std::string> made;

    /// Notes the jobs that it gets and fills their tables with nines.
    nlohmann::ordered_json make(const Job& job)
    {
        made.push_back(job.name);
        Table table{job.header, {}};
        table.values.assign(job.header.channels.size(),
                            std::vector<double>(job.header.cells(), 9.0));
        write_table(job.path, job.format, table, job.write);
        return {{"device", "none"}};
    }

    BatchReport run()
    {
        made.clear();
        return run_batch(jobs, [this](const Job& job, Progress&) { return make(job); });
    }
};

INSTANTIATE_TEST_SUITE_P(All, Batch, testing::Values("exr", "npy", "csv"),
                         [](const auto& format) { return format.param; });

TEST_P(Batch, MakesEqualTablesOnce)
{
    Scene scene = parse_scene(scene_text(GetParam()), "scene.toml");
    scene.tables.push_back(scene.tables.front());
    scene.tables.back().name = "again";
    jobs = plan_jobs(scene, tables);
    ASSERT_EQ(jobs.size(), 6U);
    const auto report = run();
    EXPECT_EQ(report.made, 3U);
    EXPECT_EQ(report.copied, 3U);
    EXPECT_EQ(made.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(test::contents(jobs[k].path), test::contents(jobs[k + 3].path));
        EXPECT_TRUE(is_finished(jobs[k + 3]));
    }
    EXPECT_EQ(run().kept, 6U);
    std::filesystem::remove(jobs[4].path);  // its twin is of an earlier run
    EXPECT_EQ(run().copied, 1U);
    EXPECT_THAT(made, IsEmpty());
    EXPECT_TRUE(is_finished(jobs[4]));
    const auto all = run_batch(
        jobs, [this](const Job& job, Progress&) { return make(job); }, Keep::nothing);
    EXPECT_EQ(all.made, 6U);
}

TEST_P(Batch, MakesAllAndThenKeepsAll)
{
    const auto first = run();
    EXPECT_EQ(first.made, 3U);
    EXPECT_EQ(first.kept, 0U);
    EXPECT_THAT(made, ElementsAre(jobs[0].name, jobs[1].name, jobs[2].name));
    const auto bytes = test::contents(jobs[1].path);
    const auto second = run();
    EXPECT_EQ(second.made, 0U);
    EXPECT_EQ(second.kept, 3U);
    EXPECT_THAT(made, IsEmpty());
    EXPECT_EQ(test::contents(jobs[1].path), bytes);
}

TEST_P(Batch, WritesWhatHappenedBesideTheTable)
{
    run();
    for (const Job& job : jobs) {
        const auto json = nlohmann::json::parse(test::contents(sidecar_path(job.path)));
        EXPECT_EQ(json.at("run").at("device"), "none");
        EXPECT_EQ(test::contents(job.path).find("none"), std::string::npos);
    }
}

TEST_P(Batch, GoesOnAfterAFailureWithTheSameBytes)
{
    EXPECT_THROW(run_batch(jobs,
                           [this](const Job& job, Progress&) {
                               if (made.size() == 1) throw RunError("the disk is full");
                               return make(job);
                           }),
                 RunError);
    EXPECT_TRUE(is_finished(jobs[0]));
    EXPECT_FALSE(is_finished(jobs[1]));
    EXPECT_FALSE(std::filesystem::exists(jobs[1].path));
    run();
    EXPECT_THAT(made, ElementsAre(jobs[1].name, jobs[2].name));
    EXPECT_TRUE(is_finished(jobs[1]));
}

TEST_P(Batch, MakesAnewWhatIsDefinedOtherwise)
{
    run();
    auto text = scene_text(GetParam());
    text.replace(text.find("0.2"), 3, "0.25");
    jobs = plan_jobs(parse_scene(text, "scene.toml"), tables);
    run();
    EXPECT_THAT(made, ElementsAre("steel-brdf-alpha=0.25"));

    text.replace(text.find("rho_s = 0.5"), 11, "rho_s = 0.6");
    jobs = plan_jobs(parse_scene(text, "scene.toml"), tables);
    EXPECT_EQ(run().made, 3U);
}

TEST_P(Batch, MakesAnewWhatAnotherVersionMade)
{
    auto older = jobs;
    ASSERT_EQ(older[0].header.attributes[0].first, "program");
    older[0].header.attributes[0].second = "gonio 0.0.1 (0000000)";
    std::swap(jobs, older);
    run();
    std::swap(jobs, older);
    run();
    EXPECT_THAT(made, ElementsAre(jobs[0].name));
}

TEST_P(Batch, MakesAnewWhatIsBroken)
{
    run();
    const auto bytes = test::contents(jobs[0].path);
    test::set_contents(jobs[0].path, bytes.substr(0, 40));
    test::set_contents(jobs[1].path, "");
    std::filesystem::remove(jobs[2].path);
    run();
    EXPECT_THAT(made, ElementsAre(jobs[0].name, jobs[1].name, jobs[2].name));
    EXPECT_EQ(test::contents(jobs[0].path), bytes);
}

TEST_P(Batch, RemovesWhatAKilledRunLeft)
{
    run_batch({jobs[0]}, [this](const Job& job, Progress&) { return make(job); });
    const auto left = tables / ("." + jobs[1].path.filename().string() + ".partial-999999999");
    test::set_contents(left, "half a table");
    run();
    EXPECT_THAT(made, ElementsAre(jobs[1].name, jobs[2].name));
    EXPECT_FALSE(std::filesystem::exists(left));
}

TEST(Interrupt, StopsABatchBetweenJobs)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const test::TemporaryDirectory place;
    const auto jobs = plan_jobs(parse_scene(scene_text("exr"), "scene.toml"), place.path());
    for (const int number : {SIGINT, SIGTERM}) {
        EXPECT_EXIT(
            {
                catch_interrupts();
                int calls = 0;
                try {
                    run_batch(jobs, [&](const Job&, Progress&) -> nlohmann::ordered_json {
                        ++calls;
                        ::raise(number);
                        return {};
                    });
                } catch (const Interrupted&) {
                    ::_exit(calls);
                }
            },
            testing::ExitedWithCode(1), "");
    }
}

TEST(Interrupt, EndsTheProgramTheSecondTime)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_FALSE(interrupted());
    EXPECT_NO_THROW(throw_if_interrupted());
    EXPECT_EXIT(
        {
            catch_interrupts();
            ::raise(SIGINT);
            if (interrupted()) ::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

TEST_P(Batch, SaysWhichFolderCannotBeMade)
{
    test::set_contents(place / "deep", "a file");
    try {
        run();
        FAIL();
    } catch (const RunError& fault) {
        EXPECT_EQ(fault.what(), tables.string() + ": cannot be made: Not a directory");
    }
    EXPECT_THAT(made, IsEmpty());
}

TEST_P(Batch, RefusesATableLargerThanTheDiskBeforeAnything)
{
    auto text = scene_text(GetParam());
    text.replace(text.find("theta_i = 4, theta_o = 3, delta_phi = 2"), 39,
                 "theta_i = 60000, theta_o = 60000, delta_phi = 60000");
    jobs = plan_jobs(parse_scene(text, "scene.toml"), tables);
    try {
        run();
        FAIL();
    } catch (const UsageError& fault) {
        EXPECT_THAT(fault.what(), testing::StartsWith("scene.toml:7:1: with the table "
                                                      "`steel-brdf-alpha=0.1` of 60000 x 60000 x "
                                                      "60000 cells the files in "));
        EXPECT_THAT(fault.what(), HasSubstr(GetParam() == "csv" ? "9.43e+03 TiB" : "786 TiB"));
    }
    EXPECT_THAT(made, IsEmpty());
    EXPECT_FALSE(std::filesystem::exists(tables));
}

}  // namespace
}  // namespace gonio

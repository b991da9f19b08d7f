// SPDX-License-Identifier: Apache-2.0
// Tables of skin by photons that are stopped again and again.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "gonio/job.hpp"
#include "skin/profile_table.hpp"

namespace gonio {
namespace {

/// Dark, so that photons are soon at their end.
Job job_of(const std::string& table)
{
    const std::string skin =
        "[[material]]\nname = \"stopped\"\nskin = \"jacques_1998\"\nparameters = { melanin = { "
        "values "
        "= [0.5, 1] } }\n[[table]]\nmaterial = \"stopped\"\nformat = \"npy\"\n";
    return plan_jobs(parse_scene(skin + table, "s.toml"), testing::TempDir()).at(0);
}

std::string bytes_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Stops within a set's first base, at the ends of batches and between them, and in later ones.
void expect_the_same_bytes(const Job& job, int launches)
{
    make_profile_table(Device(), job, [](double) {});
    const std::string expected = bytes_of(job.path), checkpoint = job.path.string() + ".checkpoint";
    std::filesystem::remove(job.path);
    int interruptions = 0;
    double reached = 0;
    for (bool finished = false; !finished;) {
        int left = interruptions < 3 ? interruptions + 1 : launches;
        try {
            double before = reached;
            make_profile_table(Device(), job, [&](double part) {
                EXPECT_GT(part, 0.8 * std::exchange(before, 0));  // noise tells it by an error
                reached = part;
                if (--left == 0) throw std::runtime_error("interrupted");
            });
            finished = true;
        } catch (const std::runtime_error&) {
            ++interruptions;
            EXPECT_FALSE(std::filesystem::exists(job.path));
            EXPECT_TRUE(std::filesystem::exists(checkpoint));
        }
    }
    EXPECT_GT(interruptions, 4);
    EXPECT_EQ(bytes_of(job.path), expected);
    EXPECT_FALSE(std::filesystem::exists(checkpoint));
}

const std::string spectrum =
    "quantity = \"reflectance_r\"\n"
    "axes = { wavelength = { values = [380, 400] }, r = { to = 0.1, count = 4 } }\n";

TEST(TracedSets, GoOnWithSpectraToTheSameBytes)
{
    expect_the_same_bytes(job_of(spectrum + "photons = 524288\n"), 90);  // two launches a batch
}

TEST(TracedSets, GoOnToAnErrorToTheSameBytes)
{
    expect_the_same_bytes(job_of(spectrum + "max_error = 0.03\n"), 40);
}

TEST(TracedSets, GoOnWithSmallerErrorsOfBasesToTheSameBytes)
{
    expect_the_same_bytes(job_of("quantity = \"reflectance_r\"\nmax_error = 0.05\n"
                                 "axes = { wavelength = { from = 400, to = 780, count = 20 }, r = "
                                 "{ to = 0.1, count = 20 } }\n"),
                          40);
}

TEST(TracedSets, GoOnWithColoursToTheSameBytes)
{
    expect_the_same_bytes(job_of("quantity = \"profile_rgb\"\nphotons = 4096\n"
                                 "axes = { r = { to = 0.1, count = 4 } }\n"),
                          150);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Scene files that are right.
#include "gonio/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/job.hpp"

namespace gonio {
namespace {

TEST(ExampleScenes, AreRightAndCanBePlanned)
{
    for (const auto name : {"quickstart", "brushed_steel", "merl"}) {
        const auto scene =
            load_scene(std::filesystem::path(SCENES) / (std::string(name) + ".toml"));
        EXPECT_THAT(scene.warnings, testing::IsEmpty());
        EXPECT_FALSE(plan_jobs(scene).empty());
    }
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Parameters and sweeps that are wrong: each message, and the place that it points at (the @).
#include <gmock/gmock.h>

#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::bad_grid;
using test::bad_material;
using test::bad_parameter;

TEST(BadParameter, HasAModelParameterOrOptionThatIsUnknown)
{
    EXPECT_EQ(bad_material("model = @\"wrad\""), "there is no model `wrad`; did you mean `ward`?");
    EXPECT_EQ(bad_parameter("@alhpa = 0.1"),
              "model `ward` has no parameter `alhpa`; did you mean `alpha`?");
    EXPECT_EQ(bad_material("model = \"ggx\"\nparameters = { fresnel = @\"shlick\" }"),
              "`fresnel` has no option `shlick`; did you mean `schlick`?");
    EXPECT_EQ(bad_material("model = \"ggx\"\nparameters = { fresnel = @2 }"),
              "`fresnel` is a choice by name, not a number");
    EXPECT_EQ(bad_material("lobes = [ { model = @\"lambrt\" } ]"),
              "there is no model `lambrt`; did you mean `lambert`?");
}

TEST(BadParameter, IsAFileThatCannotBeRead)
{
    const std::string lebedev = "model = \"lebedev\"\n[material.parameters]\n";
    EXPECT_THAT(
        bad_material(lebedev + "residual = @\"missing.exr\""),
        testing::AllOf(testing::HasSubstr("missing.exr: "),
                       testing::HasSubstr("; a residual is a table over theta_h, theta_d")));
    EXPECT_EQ(bad_material(lebedev + "residual = @1"),
              "`residual` is read from a file, not a number");
    EXPECT_EQ(bad_material(lebedev + "k_d = 0.1\n@residual = \"missing.exr\""),
              "`k_d` and `residual` both set `k_d`");
}

TEST(BadParameter, HasANumberOutOfRange)
{
    EXPECT_EQ(bad_parameter("alpha_x = @7"), "`alpha_x` is 7; allowed is 1e-05 to 1");
    EXPECT_EQ(bad_parameter("rho_s = @[0.5, -1]"), "`rho_s` is -1; allowed is 0 to 1");
    EXPECT_EQ(bad_parameter("rho_s = @[0.1, 0.1, 0.1, 0.1, 0.1]"),
              "`rho_s` has 5 numbers; allowed is one, or one for each of up to 4 channels");
    EXPECT_EQ(bad_parameter("rho_s = @[]"),
              "`rho_s` has 0 numbers; allowed is one, or one for each of up to 4 channels");
    EXPECT_EQ(bad_parameter("alpha_x = @[0.1, 0.2]"), "`alpha_x` is one number, not 2");
    EXPECT_EQ(bad_material("model = \"lambert\"\nweight = @-1"),
              "`weight` is -1; allowed is 0 to 1000000");
    EXPECT_EQ(bad_parameter("alpha_x = @9223372036854775807"),
              "`alpha_x` is 9.223372036854776e+18; allowed is 1e-05 to 1");
}

TEST(BadParameter, HasANumberThatIsNone)
{
    EXPECT_EQ(bad_parameter("alpha_x = @nan"), "`alpha_x` is nan; allowed is a finite number");
    EXPECT_EQ(bad_parameter("rho_s = [ 0.1, @inf, 0.1 ]"),
              "`rho_s[1]` is inf; allowed is a finite number");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = @nan, theta_o = 1, delta_phi = 1"),
              "`theta_i` is nan; allowed is a finite number");
}

TEST(BadParameter, SetsAParameterTwice)
{
    EXPECT_EQ(bad_parameter("alpha = 0.1\n@alpha_y = 0.2"),
              "`alpha` and `alpha_y` both set `alpha_y`");
    EXPECT_EQ(bad_parameter("alpha_y = 0.1\n@alpha = 0.2"),
              "`alpha_y` and `alpha` both set `alpha_y`");
    EXPECT_EQ(bad_material("model = \"ggx\"\n[material.parameters]\n@ndf = \"beckmann\""),
              "`ggx` and `ndf` both set `ndf`");
    EXPECT_EQ(bad_material("model = \"ward\"\nweight = 1\nparameters = { @weight = 2 }"),
              "`weight` and `weight` both set `weight`");
}

TEST(BadParameter, SweepsNothing)
{
    EXPECT_EQ(bad_parameter("alpha_x = { values = @[] }"),
              "a sweep of nothing; allowed is at least one value");
    EXPECT_EQ(bad_parameter("alpha_x = { from = 0.1, to = 0.5, count = @0 }"),
              "a sweep of 0 values over a range; allowed is 2 (both ends) to 65536");
    EXPECT_EQ(bad_parameter("alpha_x = @{ from = 0.1, count = 3 }"), "`alpha_x` needs a `to`");
}

TEST(BadParameter, SweepsBadly)
{
    EXPECT_EQ(bad_parameter("alpha_x = @{ from = 0.1, to = 2, count = 3 }"),
              "`alpha_x` is 2; allowed is 1e-05 to 1");
    EXPECT_EQ(bad_parameter("alpha_x = { from = @0, to = 1, count = 3, spacing = \"log\" }"),
              "`from` is not above 0, as spacing = \"log\" needs");
    EXPECT_EQ(bad_parameter("alpha_x = { from = 1, to = @-1, count = 3, spacing = \"log\" }"),
              "`to` is not above 0, as spacing = \"log\" needs");
    EXPECT_EQ(bad_parameter("alpha_x = @{ from = 0.1, to = 0.1, count = 3 }"),
              "the values of an axis must all ascend or all descend");
    EXPECT_EQ(bad_parameter("alpha_x = @{ values = [0.1, 0.3, 0.2] }"),
              "the values of an axis must all ascend or all descend");
    EXPECT_EQ(bad_parameter("alpha_x = @{ values = [0.1, 0.3, 0.1], as = \"files\" }"),
              "a value is there twice");
    EXPECT_EQ(bad_parameter("alpha_x = { values = [0.1], as = @\"file\" }"),
              "`as` cannot be \"file\"; did you mean `files`?");
    EXPECT_EQ(bad_parameter("alpha_x = { values = [0.1], @count = 3 }"),
              "unknown key `count`; known are: values, as");
    EXPECT_EQ(bad_parameter("alpha_x = { from = 0.1, to = 0.5, count = @1e9 }"),
              "`count` is 1000000000; allowed is a whole number from 2 to 65536");
}

}  // namespace
}  // namespace gonio

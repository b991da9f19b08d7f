// SPDX-License-Identifier: Apache-2.0
// Tables that are wrong: each message, and the place that it points at (the @).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::bad_grid;
using test::bad_output;
using test::bad_request;
using test::bad_table;
using testing::HasSubstr;
using testing::StartsWith;

TEST(BadTable, AsksForWhatThereIsNot)
{
    EXPECT_EQ(bad_table("material = @\"stele\"\nquantity = \"brdf\""),
              "there is no material `stele`; did you mean `steel`?");
    EXPECT_EQ(
        bad_table("material = \"steel\"\nquantity = @\"brfd\"\ngrid = { kind = \"isotropic\", "
                  "theta_i = 2, theta_o = 3, delta_phi = 4 }"),
        "there is no quantity `brfd`; did you mean `brdf`?");
    EXPECT_EQ(bad_request("solver = @\"monte_carlo\""),
              "`solver` cannot be \"monte_carlo\"; known are: auto, closed_form");
    EXPECT_EQ(bad_request("format = @\"exe\""), "`format` cannot be \"exe\"; did you mean `exr`?");
    EXPECT_EQ(bad_request("compression = @\"zpi\""),
              "`compression` cannot be \"zpi\"; did you mean `zips`?");
}

TEST(BadTable, HasAnEmptyGrid)
{
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = @0, theta_o = 1, delta_phi = 1"),
              "`theta_i` is 0; allowed is a whole number from 1 to 65536");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = 1, theta_o = 1, delta_phi = @-3"),
              "`delta_phi` is -3; allowed is a whole number from 1 to 65536");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = @2.5, theta_o = 1, delta_phi = 1"),
              "`theta_i` is 2.5; allowed is a whole number from 1 to 65536");
    EXPECT_EQ(
        bad_table("material = \"steel\"\nquantity = \"brdf\"\ngrid = @{ kind = \"isotropic\", "
                  "theta_i = 1, theta_o = 1, delta_phi = 1, samples = \"node\" }"),
        "axis `theta_i` has 1 samples; allowed is at least 2 nodes, the two ends");
}

TEST(BadTable, HasAGridThatOverflows)
{
    EXPECT_EQ(
        bad_table("material = \"steel\"\nquantity = \"brdf\"\ngrid = @{ kind = \"anisotropic\", "
                  "theta_i = 65536, phi_i = 65536, theta_o = 65536, phi_o = 65536 }"),
        "a grid of 1.84e+19 cells, 6.87e+10 GiB for each channel; allowed are 1.13e+15 cells");
    EXPECT_EQ(
        bad_table("material = \"steel\"\nquantity = \"brdf\"\ngrid = @{ kind = \"isotropic\", "
                  "theta_i = 1e300, theta_o = 1, delta_phi = 1 }"),
        "a grid of 1e+300 cells, 3.73e+291 GiB for each channel; allowed are 1.13e+15 cells");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = @65537, theta_o = 1, delta_phi = 1"),
              "`theta_i` is 65537; allowed is a whole number from 1 to 65536");
}

TEST(BadTable, HasAGridOfAnotherKind)
{
    EXPECT_EQ(bad_grid("kind = @\"isotropc\""),
              "`kind` cannot be \"isotropc\"; did you mean `isotropic`?");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = 2, theta_o = 3, delta_phi = 4, "
                       "delta_phi_to = @90"),
              "`delta_phi_to` is 90; allowed is 180 or 360 deg");
    EXPECT_EQ(bad_request("axes = @{ r = { to = 1, count = 3 } }"),
              "the quantity `brdf` has no `axes`, it needs a `grid`");
    const std::string merl = "material = \"steel\"\nquantity = \"brdf\"\nformat = \"merl\"\n";
    EXPECT_THAT(bad_table(merl + "grid = @{ kind = \"rusinkiewicz\", theta_h = 90, theta_d = 90, "
                                 "phi_d = 180 }"),
                StartsWith("the format merl holds a rusinkiewicz grid of 90 x 90 x 180"));
    EXPECT_EQ(bad_table(merl + "grid = { kind = \"rusinkiewicz\", theta_h = 90, theta_d = 90, "
                               "phi_d = 180, spacing = \"merl\" }"),
              "");
}

TEST(BadTable, HasAGridWithoutCounts)
{
    const std::string table = "material = \"steel\"\nquantity = \"brdf\"\n";
    EXPECT_EQ(bad_table(table + "grid = @{ kind = \"isotropic\" }"),
              "this grid needs a count for each of its angles, or the table a `max_error` that "
              "interpolation keeps to, or a `time`");
    EXPECT_EQ(bad_table(table + "time = \"1 s\"\ngrid = { kind = \"isotropic\" }"), "");
    const std::string asked = table + "max_error = 0.1\n";
    EXPECT_EQ(bad_table(asked + "grid = { kind = \"anisotropic\", interpolation = \"cubic\" }"),
              "");
    EXPECT_THAT(bad_table(asked + "grid = { kind = \"isotropic\", interpolation = @\"cubc\" }"),
                HasSubstr("did you mean `cubic`"));
    EXPECT_THAT(bad_table(asked + "grid = { kind = \"anisotropic\", @delta_phi_to = 180 }"),
                HasSubstr("unknown key `delta_phi_to`"));
    EXPECT_THAT(bad_table(asked + "grid = @{ kind = \"isotropic\", theta_i = 4 }"),
                HasSubstr("`theta_o`"));
}

TEST(BadTable, StoresWhatAFormatCannotHold)
{
    EXPECT_EQ(bad_request("format = \"npy\"\nprecision = @\"half\""),
              "`precision` is for the format exr, not npy");
    EXPECT_EQ(bad_output("format = \"csv\"\ncompression = @\"zip\""),
              "`compression` is for the format exr, not csv");
}

TEST(BadTable, HasABudget)
{
    EXPECT_EQ(bad_request("max_error = @-1"), "`max_error` is -1; allowed is 1e-14 to 1");
    EXPECT_EQ(bad_request("photons = @0.5"),
              "`photons` is 0.5; allowed is a whole number from 1 to 4611686018427387904");
    for (const std::string time : {"", "5", "5 parsec", "s", "-1 s", "1e99 s", "nan s"})
        EXPECT_EQ(
            bad_request("time = @\"" + time + "\""),
            fmt::format("`time` cannot be \"{}\"; allowed is a time such as \"5 s\", \"2 min\" "
                        "or \"1 h\"",
                        time));
    EXPECT_EQ(bad_request("max_error = @1e-3"),
              "a grid with counts has no `max_error`: leave the counts away, and they are chosen "
              "by it");
    EXPECT_EQ(bad_request("time = @\"5 s\""),
              "a grid with counts has no `time`: leave the counts away, and they are chosen by it");
    EXPECT_EQ(bad_request("photons = @1e6"),
              "the quantity `brdf` has no `photons`: its closed form is exact everywhere");
}

}  // namespace
}  // namespace gonio

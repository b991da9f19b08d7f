// SPDX-License-Identifier: Apache-2.0
// Scenes that are wrong: each message, and the place that it points at (the @).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "output/table_fixtures.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::refusal;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string bad_output(const std::string& lines)
{
    return refusal(test::SceneText{.output = lines}.text());
}

std::string bad_material(const std::string& lines)
{
    return refusal(test::SceneText{.material = "name = \"steel\"\n" + lines}.text());
}

std::string bad_parameter(const std::string& line)
{
    return bad_material("model = \"ward\"\n[material.parameters]\n" + line);
}

std::string bad_table(const std::string& lines)
{
    return refusal(test::SceneText{.table = lines}.text());
}

std::string bad_grid(const std::string& pairs)
{
    return refusal(test::SceneText{.grid = pairs}.text());
}

/// A table that is right up to these lines.
std::string bad_request(const std::string& lines)
{
    return bad_table(
        "material = \"steel\"\nquantity = \"brdf\"\ngrid = { kind = \"isotropic\", "
        "theta_i = 2, theta_o = 3, delta_phi = 4 }\n" +
        lines);
}

TEST(SceneText, IsRightAsItIs)
{
    EXPECT_EQ(refusal(test::SceneText{}.text()), "");
}

TEST(BadScene, IsNoToml)
{
    EXPECT_THAT(refusal("[output]\nformat = @\n"), StartsWith("not TOML: "));
    EXPECT_THAT(refusal("[output]\nformat = 1\nformat = @2\n"), HasSubstr("redefine"));
    EXPECT_THAT(refusal("@\xff"), HasSubstr("utf-8"));
}

TEST(BadScene, CannotBeRead)
{
    const test::TemporaryDirectory directory;
    const auto message = [](const std::filesystem::path& path) -> std::string {
        try {
            load_scene(path);
        } catch (const UsageError& fault) {
            return fault.what();
        }
        return {};
    };
    const auto missing = directory / "missing.toml";
    EXPECT_EQ(message(missing), missing.string() + ": cannot be read: No such file or directory");
    EXPECT_EQ(message(directory.path()),
              directory.path().string() + ": cannot be read: Is a directory");
    EXPECT_EQ(message("/dev/zero"), "/dev/zero: is larger than 16 MiB, which no scene is");
}

TEST(BadScene, AsksForNothing)
{
    EXPECT_EQ(refusal("@"), "the scene asks for no [[table]]");
    EXPECT_EQ(refusal("@[output]\n"), "the scene asks for no [[table]]");
}

TEST(BadScene, HasAnUnknownKey)
{
    EXPECT_EQ(refusal("[@outptu]\n"), "unknown key `outptu`; did you mean `output`?");
    EXPECT_EQ(bad_output("@fromat = \"exr\""), "unknown key `fromat`; did you mean `format`?");
    EXPECT_EQ(bad_material("@modle = \"ward\""), "unknown key `modle`; did you mean `model`?");
    EXPECT_EQ(bad_material("model = \"ward\"\n@n_above = 1"),
              "unknown key `n_above`; known are: name, model, weight, parameters");
    EXPECT_EQ(bad_table("@quanttiy = \"brdf\""),
              "unknown key `quanttiy`; did you mean `quantity`?");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = 1, theta_o = 1, @delta_ph = 1"),
              "unknown key `delta_ph`; did you mean `delta_phi`?");
    EXPECT_EQ(bad_parameter("alpha_x = { @form = 0.1, to = 1, count = 2 }"),
              "unknown key `form`; did you mean `from`?");
}

TEST(BadScene, LacksAKey)
{
    EXPECT_EQ(refusal("@[[material]]\nmodel = \"ward\"\n"), "`material[0]` needs a `name`");
    EXPECT_EQ(
        refusal("@[[material]]\nname = \"steel\"\n"),
        "a material is one of `model`, `lobes`, `layers` and `skin`, and this one has none of "
        "them");
    EXPECT_EQ(refusal("[[material]]\nname = \"a\"\nmodel = \"ward\"\n@[[table]]\nmaterial = \"a\"\n"
                      "quantity = \"brdf\"\n"),
              "`table[0]` needs a `grid`");
    EXPECT_EQ(bad_table("material = \"steel\"\nquantity = \"brdf\"\n"
                        "grid = @{ kind = \"isotropic\", theta_i = 2 }"),
              "`grid` needs a `theta_o`");
}

TEST(BadScene, HasAValueOfTheWrongType)
{
    EXPECT_EQ(refusal("output = @3\n"), "`output` is a number; allowed is a table");
    EXPECT_EQ(refusal("@[material]\nname = \"steel\"\n"),
              "`material` is a table; allowed is a list");
    EXPECT_EQ(refusal("material = [ @3 ]\n"), "`material[0]` is a number; allowed is a table");
    EXPECT_EQ(bad_output("directory = @[]"), "`directory` is a list; allowed is a text");
    EXPECT_EQ(bad_material("model = @true"), "`model` is true or false; allowed is a text");
    EXPECT_EQ(bad_parameter("alpha_x = @1979-05-27"),
              "`alpha_x` is a date or time; allowed is a number");
    EXPECT_EQ(bad_parameter("alpha_x = @\"rough\""), "`alpha_x` is a number, not \"rough\"");
    EXPECT_EQ(bad_parameter("rho_s = [ 0.1, @\"red\" ]"),
              "`rho_s[1]` is a text; allowed is a number");
    EXPECT_EQ(bad_grid("kind = @1, theta_i = 1"),
              "`kind` is a number; allowed is one of \"isotropic\", \"anisotropic\", "
              "\"rusinkiewicz\"");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = @\"many\", theta_o = 1, delta_phi = 1"),
              "`theta_i` is a text; allowed is a whole number from 1 to 65536");
}

TEST(BadScene, TakesWholeNumbersForFloats)
{
    EXPECT_EQ(bad_parameter("alpha = 1\nrho_s = [1, 0, 0]"), "");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = 2.0, theta_o = 1e1, delta_phi = 4"), "");
}

TEST(BadScene, HasAModelParameterOrOptionThatIsUnknown)
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

TEST(BadScene, HasANumberOutOfRange)
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

TEST(BadScene, HasANumberThatIsNone)
{
    EXPECT_EQ(bad_parameter("alpha_x = @nan"), "`alpha_x` is nan; allowed is a finite number");
    EXPECT_EQ(bad_parameter("rho_s = [ 0.1, @inf, 0.1 ]"),
              "`rho_s[1]` is inf; allowed is a finite number");
    EXPECT_EQ(bad_grid("kind = \"isotropic\", theta_i = @nan, theta_o = 1, delta_phi = 1"),
              "`theta_i` is nan; allowed is a finite number");
}

TEST(BadScene, SetsAParameterTwice)
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

TEST(BadScene, HasAMaterialOfTwoKindsOrNone)
{
    const auto two = "@[[material]]\nname = \"a\"\nmodel = \"ward\"\nlobes = []\n";
    EXPECT_EQ(
        refusal(two),
        "a material is one of `model`, `lobes`, `layers` and `skin`, not `model` and `lobes`");
    EXPECT_EQ(bad_material("lobes = @[]"), "a sum of no lobes; allowed is at least one");
    EXPECT_EQ(
        refusal("@[[material]]\nname = \"a\"\nlobes = [ { model = \"lambert\", weight = [1, 1] }, "
                "{ model = \"lambert\", parameters = { rho = [1, 1, 1] } } ]\n"),
        "`weight` has 2 numbers where the material has 3 channels");
}

TEST(BadScene, UsesANameTwice)
{
    const test::SceneText right;
    EXPECT_EQ(refusal(right.text() + "@[[material]]\nname = \"steel\"\nmodel = \"ward\"\n"),
              "there is a material `steel` already: scene.toml:3:1");
    EXPECT_EQ(refusal(right.text() + "@[[table]]\nmaterial = \"steel\"\nquantity = \"brdf\"\n"
                                     "grid = { kind = \"isotropic\", theta_i = 2, theta_o = 3, "
                                     "delta_phi = 4 }\n"),
              "there is a table `steel-brdf` already: scene.toml:6:1");
}

TEST(BadScene, HasANameThatIsNoFileName)
{
    for (const std::string name : {"", ".steel", "a/b", "a\\nb", "a\\u007f"})
        EXPECT_THAT(refusal("[[material]]\nname = @\"" + name + "\"\nmodel = \"ward\"\n"),
                    StartsWith("`name` is part of a file's name: allowed are 1 to 100 bytes"));
    EXPECT_THAT(bad_request("name = @\"" + std::string(101, 'a') + "\""),
                StartsWith("`name` is part of a file's name"));
}

TEST(BadScene, AsksForWhatThereIsNot)
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

TEST(BadScene, HasAnEmptyGrid)
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

TEST(BadScene, HasAGridThatOverflows)
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

TEST(BadScene, HasAGridOfAnotherKind)
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

TEST(BadScene, StoresWhatAFormatCannotHold)
{
    EXPECT_EQ(bad_request("format = \"npy\"\nprecision = @\"half\""),
              "`precision` is for the format exr, not npy");
    EXPECT_EQ(bad_output("format = \"csv\"\ncompression = @\"zip\""),
              "`compression` is for the format exr, not csv");
}

TEST(BadScene, SweepsNothing)
{
    EXPECT_EQ(bad_parameter("alpha_x = { values = @[] }"),
              "a sweep of nothing; allowed is at least one value");
    EXPECT_EQ(bad_parameter("alpha_x = { from = 0.1, to = 0.5, count = @0 }"),
              "a sweep of 0 values over a range; allowed is 2 (both ends) to 65536");
    EXPECT_EQ(bad_parameter("alpha_x = @{ from = 0.1, count = 3 }"), "`alpha_x` needs a `to`");
}

TEST(BadScene, SweepsBadly)
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

TEST(SceneOfLayers, IsReadWholeAndRefusedAtTheQuantity)
{
    const auto refused =
        "this version computes no table of layers or skin, only of a `model` or of "
        "`lobes`";
    const std::string table =
        "[[table]]\nmaterial = \"forearm\"\nquantity = @\"reflectance_r\"\n"
        "axes = { r = { to = 2.0, count = 200 } }\nmax_error = 1e-3\n"
        "time = \"5 min\"\nphotons = 1e9\n";
    const std::string name = "[[material]]\nname = \"forearm\"\n";
    EXPECT_EQ(refusal(name +
                      "n_below = 1.4\nbottom = \"open\"\nlayers = [ { mua = 0.2, mus = 1000, "
                      "g = 0.9, n = 1.53, d = 0.002 }, { mua = 0.7, mus = { from = 100, to = "
                      "200, count = 3 }, phase = \"rayleigh\", n = 1.4, d = inf } ]\n" +
                      table),
              refused);
    EXPECT_EQ(
        refusal(name + "skin = \"jacques\"\nparameters = { melanin = { values = [0.1, 0.2] } }\n" +
                table),
        refused);
}

TEST(SceneOfLayers, IsCheckedBefore)
{
    const auto bad_layers = [](const std::string& lines) {
        return refusal("[[material]]\nname = \"forearm\"\n" + lines);
    };
    EXPECT_EQ(bad_layers("layers = @[]\n"), "a layered medium needs at least one layer");
    EXPECT_EQ(bad_layers("layers = @[ { mua = -1 } ]\n"),
              "layer 1: mua = -1 must be finite and at least 0 1/cm");
    EXPECT_EQ(bad_layers("layers = [ { @mue = 1 } ]\n"), "unknown key `mue`; did you mean `mua`?");
    EXPECT_EQ(bad_layers("layers = [ { mua = 1, phase = \"rayleigh\", @g = 0.9 } ]\n"),
              "unknown key `g`; did you mean `n`?");
    EXPECT_EQ(bad_layers("layers = [ { mua = 1 } ]\nbottom = @\"blak\"\n"),
              "`bottom` cannot be \"blak\"; did you mean `black`?");
    EXPECT_EQ(bad_layers("layers = [ { mua = 1, d = @nan } ]\n"),
              "`d` is nan; allowed is at least 0");
}

TEST(BadBudget, IsRefused)
{
    EXPECT_EQ(bad_request("max_error = @-1"), "`max_error` is -1; allowed is 0 to 1");
    EXPECT_EQ(bad_request("photons = @0.5"),
              "`photons` is 0.5; allowed is a whole number from 1 to 4611686018427387904");
    for (const std::string time : {"", "5", "5 parsec", "s", "-1 s", "1e99 s", "nan s"})
        EXPECT_EQ(
            bad_request("time = @\"" + time + "\""),
            fmt::format("`time` cannot be \"{}\"; allowed is a time such as \"5 s\", \"2 min\" "
                        "or \"1 h\"",
                        time));
    for (const std::string budget : {"max_error = @1e-3", "time = @\"5 s\"", "photons = @1e6"})
        EXPECT_THAT(bad_request(budget),
                    HasSubstr("for the quantity `brdf`, whose closed form is exact"));
}

}  // namespace
}  // namespace gonio

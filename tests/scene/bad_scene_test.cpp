// SPDX-License-Identifier: Apache-2.0
// Scenes that are wrong: each message, and the place that it points at (the @).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "output/table_fixtures.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::bad_grid;
using test::bad_material;
using test::bad_output;
using test::bad_parameter;
using test::bad_request;
using test::bad_table;
using test::refusal;
using testing::HasSubstr;
using testing::StartsWith;

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
    EXPECT_EQ(message("/dev/zero"),
              "/dev/zero: is larger than 16 MiB, which no scene and no model is");
}

TEST(BadScene, AsksForNothing)
{
    EXPECT_EQ(refusal("@"), "the scene asks for no [[table]] and no [picture]");
    EXPECT_EQ(refusal("@[output]\n"), "the scene asks for no [[table]] and no [picture]");
}

TEST(BadScene, HasAnUnknownKey)
{
    EXPECT_EQ(refusal("[@outptu]\n"), "unknown key `outptu`; did you mean `output`?");
    EXPECT_EQ(bad_output("@fromat = \"exr\""), "unknown key `fromat`; did you mean `format`?");
    EXPECT_EQ(bad_material("@modle = \"ward\""), "unknown key `modle`; did you mean `model`?");
    EXPECT_EQ(bad_material("model = \"ward\"\n@n_above = 1"),
              "unknown key `n_above`; known are: name, model, weight, parameters, "
              "ambient");
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
    EXPECT_EQ(refusal("@[[material]]\nname = \"steel\"\n"),
              "a material is one of `model`, `lobes`, `diffuse` with `specular`, `layers` and "
              "`skin`, and this one has none of "
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

TEST(BadScene, HasAMaterialOfTwoKindsOrNone)
{
    const auto two = "@[[material]]\nname = \"a\"\nmodel = \"ward\"\nlobes = []\n";
    EXPECT_EQ(refusal(two),
              "a material is one of `model`, `lobes`, `diffuse` with `specular`, `layers` and "
              "`skin`, not `model` and `lobes`");
    EXPECT_EQ(bad_material("lobes = @[]"), "a sum of no lobes; allowed is at least one");
    EXPECT_EQ(bad_material("diffuse = { model = \"lambert\", @parameter = {} }"),
              "unknown key `parameter`; did you mean `parameters`?");
    EXPECT_EQ(bad_material("model = \"ward\"\nambient = @-1"),
              "`ambient` is -1; allowed is a radiance of 0 to 1e6");
    EXPECT_EQ(bad_material("model = \"ward\"\nambient = @[1, 2]"),
              "`ambient` has 2 numbers; allowed is one, or one for each of 1 channels");
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

}  // namespace
}  // namespace gonio

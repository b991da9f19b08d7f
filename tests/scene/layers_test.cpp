// SPDX-License-Identifier: Apache-2.0
// Layers and skin: read and checked whole, and refused where a table asks for what is not computed.
#include <gtest/gtest.h>

#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using test::refusal;

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

}  // namespace
}  // namespace gonio

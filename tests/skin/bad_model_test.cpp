// SPDX-License-Identifier: Apache-2.0
// What files of skin models are refused for, and where.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gonio/errors.hpp"
#include "gonio/skin.hpp"

namespace gonio {
namespace {

/// "line:column: message" of a model with such lines in front of its one layer.
std::string refusal(const std::string& lines, const std::string& layer = "absorption = 1\n")
{
    const std::string file = testing::TempDir() + "bad_skin.toml";
    std::ofstream(file) << lines << "[[layers]]\nname = \"x\"\nd = 1\nn = 1.4\nmus = 1\ng = 0\n"
                        << layer;
    try {
        Skin skin(find_skin_model(file));
        return "nothing is refused";
    } catch (const UsageError& error) {
        const std::string text = error.what();
        EXPECT_TRUE(text.starts_with(file + ":")) << text;
        return text.substr(std::min(file.size() + 1, text.size()));
    }
}

TEST(BadSkinModel, IsRefusedAtItsPlace)
{
    EXPECT_EQ(refusal("titel = \"\"\n"), "1:1: unknown key `titel`; did you mean `title`?");
    EXPECT_EQ(refusal("", "absorption = \"melanosom\"\n"),
              "7:14: there is no substance `melanosom`; did you mean `melanosome`?");
    EXPECT_EQ(refusal("", "absorption = { mixture = { watre = 0.5 } }\n"),
              "7:28: there is no substance `watre`; did you mean `water`?");
    EXPECT_EQ(refusal("", "absorption = { mixture = { water = 1.5 } }\n"),
              "7:14: the volume fraction of `water` is 1.5; allowed is 0 to 1");
    EXPECT_EQ(refusal("", "absorption = { mixture = { water = 0.6, baseline = 0.5 } }\n"),
              "7:14: the volume fractions sum to 1.1; allowed is 1");
    EXPECT_EQ(refusal("", "absorption = { mixture = { bilirubin = 0.6 } }\n"),
              "7:40: `bilirubin` needs a concentration; it can be `dissolved`");
    EXPECT_EQ(refusal("", "absorption = { dissolved = { water = 0.6 } }\n"),
              "7:38: `water` has no absorption per g/L; it can be part of a `mixture`");
    EXPECT_EQ(refusal("", "absorption = 1\nmusp = 3\n"),
              "8:8: a layer has a `mus` or a `musp`, not both");
    EXPECT_EQ(refusal("[parameters.m]\ndoc = \"\"\nleast = 0\ngreatest = 1\ndefault = 2\n"),
              "5:11: `default` is 2; allowed is 0 to 1");
    EXPECT_EQ(refusal("[parameters.m]\ndoc = \"\"\nleast = 0\ngreatest = 1\ndefault = 0\n"),
              "1:1: nothing uses the parameter `m`");
    EXPECT_EQ(refusal("[substances]\na = { mixture = { b = 1 } }\nb = { mixture = { a = 1 } }\n",
                      "absorption = \"a\"\n"),
              "3:23: `a` is made of itself");
    EXPECT_EQ(refusal("",
                      "absorption = { spectrum = { file = \"none.csv\", column = \"a\", "
                      "unit = \"1/cm\" } }\n"),
              "7:36: there is no spectrum `none.csv`, neither beside the model nor built in");
    EXPECT_EQ(refusal("[laws]\nm = [{ scale = 1, power = 1, decay = 3 }]\n",
                      "absorption = { law = \"m\" }\n"),
              "2:38: a term has a `power` or a `decay`, not both");
}

TEST(BadSkinModel, MayBringASpectrumOfItsOwn)
{
    const std::filesystem::path folder = testing::TempDir();
    std::ofstream(folder / "ink.csv") << "# 1/mm\nwavelength,ink\n400,1\n500,3\n";
    std::ofstream(folder / "ink.toml")
        << "[[layers]]\nname = \"x\"\nd = 1\nn = 1.4\nmus = 1\ng = 0\nabsorption = { spectrum = { "
           "file = \"ink.csv\", column = \"ink\", unit = \"1/mm\" } }\n";
    const Skin skin(find_skin_model((folder / "ink.toml").string()));
    EXPECT_EQ(skin.least_wavelength(), 400);
    EXPECT_EQ(skin.greatest_wavelength(), 500);
    EXPECT_DOUBLE_EQ(skin.layers_at(450).layers[0].mua, 20);
}

}  // namespace
}  // namespace gonio

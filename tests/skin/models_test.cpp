// SPDX-License-Identifier: Apache-2.0
// The layers of the built-in models, against tables that another program made.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "gonio/errors.hpp"
#include "reference/csv.hpp"
#include "skin/skin_fixtures.hpp"

namespace gonio {
namespace {

using test::CsvRow;
using test::read_csv;
using test::skin_of;

TEST(SkinModels, HaveTheLayersOfTheirRecipes)
{
    constexpr double half_space = 100;  // mm, what the table calls it
    constexpr double printed = 1e-7;    // of numbers with eight digits
    const std::vector<CsvRow> rows = read_csv("skin/layers.csv");
    ASSERT_EQ(rows.size(), 1811U);
    for (const CsvRow& row : rows) {
        const std::string name = row.text("model") + " " + row.text("lambda_nm");
        const LayeredMedium medium = skin_of(row.text("model")).layers_at(row.number("lambda_nm"));
        const Layer& layer = medium.layers.at(std::stoul(row.text("layer")) - 1);
        EXPECT_NEAR(layer.mua, 10 * row.number("mua_mm"), printed * layer.mua) << name;
        EXPECT_NEAR(layer.mus, 10 * row.number("mus_mm"), printed * layer.mus) << name;
        EXPECT_NEAR(std::get<HenyeyGreenstein>(layer.phase).g, row.number("g"), 1e-12) << name;
        EXPECT_DOUBLE_EQ(layer.n, row.number("n")) << name;
        if (row.number("d_mm") == half_space)
            EXPECT_TRUE(std::isinf(layer.d)) << name;
        else
            EXPECT_DOUBLE_EQ(layer.d, row.number("d_mm") / 10) << name;
    }
}

TEST(SkinModels, SharedLawsAgreeWithAnotherEvaluation)
{
    const std::filesystem::path file = testing::TempDir() + "laws.toml";
    const std::pair<const char*, const char*> laws[] = {{"base_huang", "baseline"},
                                                        {"base_saidi", "baseline_neonatal"},
                                                        {"mel_jacques98", "melanosome"},
                                                        {"mel_jacques2013", "melanosome_2013"},
                                                        {"pheo_djensen", "melanosome_red"}};
    for (const auto& [column, substance] : laws) {
        std::ofstream(file) << "[[layers]]\nname = \"x\"\nd = 1\nn = 1.4\nmus = 1\ng = 0\n"
                            << "absorption = \"" << substance << "\"\n";
        const Skin skin(find_skin_model(file.string()));
        for (const CsvRow& row : read_csv("skin/laws.csv")) {
            const double mua = skin.layers_at(row.number("lambda_nm")).layers[0].mua;
            EXPECT_NEAR(mua, row.number(column), 1e-7 * mua) << column;
        }
    }
}

// S. Prahl, https://omlc.org/spectra/hemoglobin/: 20932.8 and 20862 1/(cm M) at 500 nm, and
// mua = ln 10 e 150 / 64500 for 150 g/L.
TEST(SkinModels, BloodIsThatOfPrahl)
{
    Skin skin(find_skin_model("delgado_2011"));
    skin.set("blood", 1);
    for (const auto& [oxygenation, extinction] : {std::pair{1.0, 20932.8}, {0.0, 20862.0}}) {
        skin.set("oxygenation", oxygenation);
        EXPECT_NEAR(skin.layers_at(500).layers[1].mua, std::log(10) * extinction * 150 / 64500,
                    1e-9 * extinction);
    }
}

// Thody et al. 1991: 80 g/L eumelanin and 12 g/L pheomelanin. Rayleigh scattering of BioSpec's
// fibres, 8 pi^3 ((n_f / n)^2 - 1)^2 / (3 N wavelength^4), with n_f = 1.5, a radius of 25 nm and a
// fifth of the volume.
TEST(SkinModels, BiospecScattersAtItsFibres)
{
    const LayeredMedium medium = Skin(find_skin_model("biospec_2004")).layers_at(550);
    const double pi = std::acos(-1), radius = 2.5e-6, wavelength = 550e-7;
    const double fibres = 0.21 / (4 * pi * std::pow(radius, 3) / 3);
    for (const std::size_t k : {2U, 3U}) {
        const double contrast = std::pow(1.5 / medium.layers[k].n, 2) - 1;
        const double mus =
            8 * std::pow(pi, 3) * contrast * contrast / (3 * fibres * std::pow(wavelength, 4));
        EXPECT_NEAR(medium.layers[k].mus, mus, 1e-3 * mus);
        EXPECT_TRUE(std::holds_alternative<Rayleigh>(medium.layers[k].phase));
    }
}

TEST(SkinModels, RefuseWhatIsOutOfRange)
{
    const auto message = [](const auto& action) {
        try {
            action();
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
        return std::string("nothing is refused");
    };
    Skin skin(find_skin_model("jacques_1998"));
    EXPECT_EQ(message([&] { skin.set("melanin", 1.5); }), "`melanin` is 1.5; allowed is 0 to 1");
    EXPECT_EQ(message([&] { skin.set("epidermis_thickness", 1); }),
              "`epidermis_thickness` is 1; allowed is 0.0001 to 0.1 cm");
    EXPECT_EQ(message([&] { skin.set("melanine", 0.1); }),
              "skin `jacques_1998` has no parameter `melanine`; did you mean `melanin`?");
    EXPECT_EQ(message([&] { skin.layers_at(1200); }),
              "1200 nm: skin `jacques_1998` is known at 250 to 1000 nm; so far goes "
              "`skin/haemoglobin.csv`");
    EXPECT_EQ(message([] { find_skin_model("jaques_1998"); }),
              "there is no skin `jaques_1998`; did you mean `jacques_1998`?");
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Skin in scenes: what is read, refused, planned and made.
#include <gtest/gtest.h>

#include <filesystem>

#include "gonio/colour.hpp"
#include "gonio/errors.hpp"
#include "gonio/job.hpp"
#include "output/table_json.hpp"
#include "reference/adding_doubling.hpp"
#include "scene/scene_fixtures.hpp"
#include "skin/profile_table.hpp"
#include "skin/skin_table.hpp"

namespace gonio {
namespace {

using test::refusal;

const std::string skin =
    "[[material]]\nname = \"arm\"\nskin = \"jacques_1998\"\n[material.parameters]\n"
    "melanin = { values = [0.02, 0.1, 0.3] }\nblood = { from = 0.001, to = 0.004, count = 2 }\n"
    "oxygenation = 0.6\n[[table]]\nmaterial = \"arm\"\nformat = \"npy\"\nmax_error = 1e-3\n";

Table made(const std::string& table)
{
    const Job job = plan_jobs(parse_scene(skin + table, "s.toml"), testing::TempDir()).at(0);
    make_skin_table(job);
    return read_table(job.path);
}

TEST(SceneOfSkin, ColoursOfMelaninAndBlood)
{
    const Table rgb = made("quantity = \"colour_rgb\"\n");
    const Table xyz = made("quantity = \"colour_xyz\"\n");
    ASSERT_EQ(rgb.header.axes.size(), 2U);
    EXPECT_EQ(rgb.header.axes[0].name, "melanin");
    EXPECT_EQ(rgb.header.axes[1].name, "blood");
    EXPECT_EQ(rgb.header.channels, (std::vector<std::string>{"R", "G", "B"}));
    Skin set(find_skin_model("jacques_1998"));
    set.set("melanin", 0.1);
    set.set("blood", 0.004);
    set.set("oxygenation", 0.6);
    const auto spectrum = solve_skin({set}, default_wavelengths(), {}, 1e-5)[0];
    const auto colour = colour_of(spectrum.wavelengths, spectrum.reflectance);
    for (std::size_t c = 0; c < 3; ++c) {
        const auto k = static_cast<int>(c);
        EXPECT_NEAR(rgb.values[c][3], colour.linear[k], 3e-3);
        EXPECT_NEAR(xyz.values[c][3], colour.xyz[k], 0.1);
    }
    EXPECT_GT(rgb.values[0][0], rgb.values[0][2]);  // more melanin is darker
    EXPECT_GT(rgb.values[1][0], rgb.values[1][1]);  // more blood takes green
}

TEST(SceneOfSkin, SpectraHaveTheirWavelengths)
{
    const Table table = made(
        "quantity = \"reflectance_spectrum\"\nlight = \"diffuse\"\n"
        "axes = { wavelength = { values = [450, 542, 650] } }\n");
    ASSERT_EQ(table.header.axes.size(), 3U);
    EXPECT_EQ(table.header.axes[2].values, (std::vector<double>{450, 542, 650}));
    EXPECT_EQ(table.header.cells(), 18U);
    EXPECT_EQ(table.header.channels.back(), "reflectance.error");
    for (const double error : table.values.back()) EXPECT_LE(error, 1e-3);
    for (std::size_t k = 0; k < 18; ++k) EXPECT_GT(table.values[0][k], table.values[1][k]);
}

TEST(SceneOfSkin, LetsLightThroughFolds)
{
    const std::string axes = "d = { values = [0.01, 0.1, 1] } }\n";
    std::string wavelengths =
        "wavelength = { from = 380, to = 780, count = 81, samples = \"node\" }, ";
    const std::string ear =
        "[[material]]\nname = \"ear\"\nskin = \"pyxopto\"\nparameters = { melanin = { values = "
        "[0.01, 0.1] } }\n[[table]]\nmaterial = \"ear\"\nformat = \"npy\"\nmax_error = 1e-3\n";
    const auto made_of = [&](const std::string& table) {
        const Job job = plan_jobs(parse_scene(ear + table, "s.toml"), testing::TempDir()).at(0);
        double done = 0;
        make_skin_table(job, [&](double part) { done = part; });
        EXPECT_NEAR(done, 1, 1e-9);
        EXPECT_EQ(definition(job), text_of(to_json(read_header(job.path))));
        return read_table(job.path);
    };
    const Table rgb = made_of("quantity = \"transmittance_rgb\"\naxes = { " + axes);
    const Table spectra = made_of("quantity = \"transmittance_d\"\naxes = { " + wavelengths + axes);
    EXPECT_EQ(rgb.header.channels, (std::vector<std::string>{"R", "G", "B"}));
    ASSERT_EQ(rgb.header.cells(), 6U);
    ASSERT_EQ(spectra.header.cells(), 486U);
    for (std::size_t set = 0; set < 2; ++set)
        for (std::size_t d = 0; d < 3; ++d) {
            std::vector<double> spectrum;
            for (std::size_t k = 0; k < 81; ++k)
                spectrum.push_back(spectra.values[0][(set * 81 + k) * 3 + d]);
            const auto linear = linear_srgb(tristimulus(default_wavelengths(), spectrum));
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(rgb.values[c][set * 3 + d], linear[static_cast<int>(c)], 3e-3);
        }
    EXPECT_GT(rgb.values[0][1], 5 * rgb.values[2][1]);  // an ear of 1 mm is red against the light
    EXPECT_GT(rgb.values[0][1], rgb.values[0][4]);      // and darker with more melanin
    EXPECT_EQ(
        refusal(ear + "quantity = \"transmittance_rgb\"\naxes = @{ d = { values = [0, 1] } }\n"),
        "`d` is 0; allowed is above 0, up to 10 cm");
    EXPECT_EQ(refusal(ear + "quantity = \"transmittance_d\"\naxes = @{ " + axes),
              "the quantity `transmittance_d` needs axes = { wavelength = { values = [400, 410, …] "
              "}, d = { to = …, count = … } }");
}

TEST(SceneOfSkin, IsLayersAtOneWavelength)
{
    const Scene scene = parse_scene(
        "[[material]]\nname = \"arm\"\nskin = \"pyxopto\"\nwavelength = 550\n[[table]]\n"
        "material = \"arm\"\nquantity = \"light_budget\"\n",
        "s.toml");
    const auto& medium = std::get<LayeredMedium>(scene.materials[0].made_of);
    EXPECT_EQ(medium.layers.size(), 2U);
    EXPECT_EQ(medium.layers[0].mua, Skin(find_skin_model("pyxopto")).layers_at(550).layers[0].mua);
}

TEST(SceneOfSkin, IsCheckedBefore)
{
    const std::string head = "[[material]]\nname = \"arm\"\n";
    EXPECT_EQ(refusal(head + "skin = @\"jaques_1998\"\n"),
              "there is no skin `jaques_1998`; did you mean `jacques_1998`?");
    EXPECT_EQ(refusal(head + "skin = \"pyxopto\"\nparameters = { @melanine = 0.1 }\n"),
              "skin `pyxopto` has no parameter `melanine`; did you mean `melanin`?");
    EXPECT_EQ(refusal(head + "skin = \"pyxopto\"\nparameters = { melanin = @{ values = [0.1, 2] } "
                             "}\n"),
              "`melanin` is 2; allowed is 0 to 1");
    EXPECT_EQ(refusal(head + "skin = \"pyxopto\"\nwavelength = @1200\n"),
              "1200 nm: skin `pyxopto` is known at 251 to 1000 nm; so far goes "
              "`skin/whole_blood.csv`");
    EXPECT_EQ(refusal(skin + "quantity = @\"colour\"\n"),
              "there is no quantity `colour`; known are: reflectance_spectrum, colour_rgb, "
              "colour_xyz, transmittance_d, transmittance_rgb, reflectance_r, profile_rgb, "
              "preintegrated_rgb");
    EXPECT_EQ(refusal(skin + "quantity = \"colour_rgb\"\naxes = @{ wavelength = { values = [500] } "
                             "}\n"),
              "the quantity `colour_rgb` has no axes");
    EXPECT_EQ(refusal(skin + "quantity = \"colour_rgb\"\n@photons = 10\n").substr(0, 21),
              "unknown key `photons`");
    EXPECT_EQ(refusal(skin + "quantity = \"colour_rgb\"\ntime = @1\n"),
              "`time` is for light that spreads, by photons; without noise each wavelength has the "
              "fewest nodes that keep to `max_error`");
    EXPECT_EQ(refusal(skin + "quantity = \"reflectance_spectrum\"\naxes = @{ wavelength = { values "
                             "= [500, 1100] } }\n"),
              "1100 nm: skin `jacques_1998` is known at 250 to 1000 nm; so far goes "
              "`skin/haemoglobin.csv`");
    const std::string arm = head + "skin = \"pyxopto\"\n[[table]]\nmaterial = \"arm\"\n";
    EXPECT_EQ(refusal(arm + "quantity = \"profile_rgb\"\naxes = @{ z = { to = 1, count = 9 } }\n"),
              "the quantity `profile_rgb` needs axes = { r = { to = …, count = … } }");
    EXPECT_EQ(refusal(arm + "quantity = \"profile_rgb\"\n@max_error = 0.1\n").substr(0, 23),
              "unknown key `max_error`");
    EXPECT_EQ(refusal(arm + "quantity = \"profile_rgb\"\n@ring_error = 0.1\n").substr(0, 24),
              "unknown key `ring_error`");
    EXPECT_EQ(refusal(head + "skin = \"pyxopto\"\nwavelength = 550\n[[table]]\nmaterial = "
                             "\"arm\"\nquantity = \"light_budget\"\nring_error = @0.1\n"),
              "`ring_error` is for `reflectance_r` of skin over wavelengths");
    EXPECT_EQ(refusal(arm + "quantity = \"preintegrated_rgb\"\naxes = @{ n_dot_l = { values = "
                            "[-1, 1] }, curvature = { values = [0, 20] } }\n"),
              "`curvature` is 20; allowed is 0 to 10");
}

TEST(SceneOfSkin, SpreadsLightOfEachWavelength)
{
    const std::string arm =
        "[[material]]\nname = \"arm\"\nskin = \"meglinski_2002\"\n[[table]]\nmaterial = \"arm\"\n"
        "format = \"npy\"\nquantity = \"reflectance_r\"\n";
    const std::string axes =
        "axes = { wavelength = { values = [450, 650] }, r = { to = 0.2, count = 4 } }\n";
    Job job =
        plan_jobs(parse_scene(arm + axes + "photons = 4096\n", "s.toml"), testing::TempDir())[0];
    const auto run = make_profile_table(Device(), job, [](double) {});
    const Table table = read_table(job.path);
    EXPECT_EQ(definition(job), text_of(to_json(table.header)));
    EXPECT_EQ(table.header.channels, (std::vector<std::string>{"Y", "Y.error"}));
    EXPECT_GT(table.values[0][4], table.values[0][0]);  // red light comes back, and spreads
    EXPECT_GT(table.values[0][7] / table.values[0][4], table.values[0][3] / table.values[0][0]);
    EXPECT_EQ(run.at("photons"), 4096);
    const Job timed =
        plan_jobs(parse_scene(arm + axes + "time = 5\n", "s.toml"), testing::TempDir())[0];
    EXPECT_EQ(timed.profile->seconds, 5);
    EXPECT_EQ(std::get<double>(*timed.header.find("time")), 5);
    EXPECT_EQ(run.at("spectra")[0].at("effective_photons").size(), 2U);

    const Job strict =
        plan_jobs(parse_scene(arm + axes + "photons = 4096\nmax_error = 1e-4\n", "s.toml"),
                  testing::TempDir())[0];
    EXPECT_THROW(make_profile_table(Device(), strict, [](double) {}), RunError);
    const Job even =
        plan_jobs(parse_scene(arm + axes + "ring_error = 0.2\n", "s.toml"), testing::TempDir())[0];
    const auto spectra = make_profile_table(Device(), even, [](double) {}).at("spectra");
    for (const double error : spectra[0].at("ring_error")) EXPECT_LE(error, 0.2);
    EXPECT_EQ(
        refusal(arm + "axes = @{ r = { to = 1, count = 9 } }\n"),
        "the quantity `reflectance_r` needs axes = { wavelength = { values = [400, 410, …] }, "
        "r = { to = …, count = … } }");
    EXPECT_EQ(refusal(arm + "axes = @{ wavelength = { values = [100] }, r = { to = 1, count = 9 } "
                            "}\n")
                  .substr(0, 34),
              "100 nm: skin `meglinski_2002` is k");
}

TEST(SceneOfSkin, SpreadsLight)
{
    const std::string scene =
        "[[material]]\nname = \"arm\"\nskin = \"pyxopto\"\n[[table]]\nmaterial = \"arm\"\n"
        "format = \"npy\"\nphotons = 4096\nquantity = \"preintegrated_rgb\"\n"
        "axes = { n_dot_l = { values = [-1, 0, 1] }, curvature = { values = [0, 0.2] } }\n";
    const Job job = plan_jobs(parse_scene(scene, "s.toml"), testing::TempDir()).at(0);
    const auto run = make_profile_table(Device(), job, [](double) {});
    const Table table = read_table(job.path);
    ASSERT_EQ(table.header.channels, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(definition(job), text_of(to_json(table.header)));
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(table.values[c][4], 1, 1e-6);  // n.l = 1 on a plane
        EXPECT_LT(table.values[c][5], 1);          // and on a sphere
        EXPECT_GT(table.values[c][3], 0);          // beyond the terminator of the sphere
    }
    EXPECT_GT(table.values[0][3], table.values[2][3]);  // which is red
    EXPECT_EQ(run.at("fits").size(), 1U);
}

}  // namespace
}  // namespace gonio

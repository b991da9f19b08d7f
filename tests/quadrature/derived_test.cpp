// SPDX-License-Identifier: Apache-2.0
// Tables of integrals as scenes ask for them: split sums, means, compensation, and bad requests.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "gonio/errors.hpp"
#include "gonio/job.hpp"
#include "output/table_fixtures.hpp"
#include "quadrature/derived.hpp"
#include "quadrature/make_integrals.hpp"
#include "quadrature/multiscatter.hpp"
#include "reference/albedo_fixtures.hpp"
#include "reference/albedo_rows.hpp"
#include "reference/gauss_legendre.hpp"
#include "scene/scene_fixtures.hpp"

namespace gonio {
namespace {

using testing::HasSubstr;

std::vector<Job> jobs_of(const std::string& material, const std::string& table)
{
    return plan_jobs(parse_scene("[[material]]\nname = \"m\"\n" + material +
                                     "\n[[table]]\nmaterial = \"m\"\n" + table + "\n",
                                 "scene.toml"));
}

DerivedTable made(const std::string& material, const std::string& table)
{
    return derive(Device("", 8), jobs_of(material, table).front());
}

std::string list(const std::vector<double>& numbers)
{
    return fmt::format("{{ values = [{}] }}", fmt::join(numbers, ", "));
}

// E = f0 scale + bias with alpha = perceptual^2.
TEST(Derived, SplitSumsOfGgx)
{
    const auto table = made("model = \"ggx\"", "quantity = \"dfg\"\n[table.axes]\nalpha = " +
                                                   list({0.01, 0.0625, 0.25, 0.5625, 1}) +
                                                   "\nmu = " + list({0.05, 0.25, 0.5, 0.75, 1}));
    for (std::size_t k = 0; k < split_sums.size(); ++k) {
        EXPECT_NEAR(table.values[0][k], split_sums[k].scale, 1e-6) << k;
        EXPECT_NEAR(table.values[1][k], split_sums[k].bias, 1e-6) << k;
    }
}

// Every ninth cell in both directions of a 64 x 64 table, against double.
TEST(Derived, TableOfGgxHasAMeanErrorBelowAMillionth)
{
    const Job job = jobs_of("model = \"ggx\"",
                            "quantity = \"dfg_multiscatter\"\n[table.axes]\nalpha = { to = 1, "
                            "count = 64, spacing = \"square\" }\nmu = { to = 1, count = 64 }")
                        .front();
    const DerivedTable table = derive(Device("", 8), job);
    double sum = 0, greatest = 0;
    int count = 0;
    for (std::size_t row = 3; row < 64; row += 9)
        for (std::size_t column = 3; column < 64; column += 9)
            for (const std::size_t f0 : {0U, 1U}) {
                const double alpha = static_cast<float>(job.header.axes[0].values[row]);
                const double mu = job.header.axes[1].values[column];
                const Brdf f = reference_of(fmt::format("ggx f0={} alpha={:.9g}", f0, alpha));
                const double error = std::abs(table.values[f0][row * 64 + column] -
                                              albedo_over_half_vectors(f, mu, alpha, 28));
                sum += error;
                greatest = std::max(greatest, error);
                ++count;
            }
    RecordProperty("mean", std::to_string(sum / count));
    EXPECT_LT(sum / count, 3e-7);
    EXPECT_LT(greatest, 1e-6);
}

TEST(Derived, MeansOfGgx)
{
    std::vector<double> alphas;
    for (const Mean& mean : means) alphas.push_back(mean.roughness);
    const auto table = made("model = \"ggx\"",
                            "quantity = \"mean_albedo\"\naxes = { alpha = " + list(alphas) + " }");
    for (std::size_t k = 0; k < means.size(); ++k)
        EXPECT_NEAR(table.values[0][k], means[k].albedo, 1e-6) << means[k].roughness;
}

// The mean of an anisotropic lobe over azimuths lies between those along the two axes.
TEST(Derived, MeansOfAnAnisotropicLobe)
{
    const auto table = made("model = \"ggx\"\nparameters = { alpha_x = 0.1, alpha_y = 0.3 }",
                            "quantity = \"mean_albedo\"\nmax_error = 1e-4");
    EXPECT_GT(table.values[0][0], 0.8468714);
    EXPECT_LT(table.values[0][0], 0.9720458);
    EXPECT_LT(table.values[1][0], 1e-4);
}

// E and the compensating lobe together reflect all light.
TEST(Derived, CompensationClosesTheFurnace)
{
    const reference::QuadratureRule rule = reference::gauss_legendre(30);
    std::vector<double> nodes;
    for (const double u : rule.nodes) nodes.push_back(u * u);
    for (const char* ndf : {"ggx", "beckmann"}) {
        const std::string material =
            fmt::format("model = \"{}\"\nparameters = {{ alpha = 0.7 }}", ndf);
        const auto lobe = made(material,
                               "quantity = \"kulla_conty\"\nmax_error = 1e-5\n"
                               "axes = { mu_i = { values = [0.1, 0.5, 1] }, mu_o = " +
                                   list(nodes) + " }");
        const auto albedo = made(material,
                                 "quantity = \"directional_albedo\"\n"
                                 "axes = { mu = { values = [0.1, 0.5, 1] } }");
        for (std::size_t i = 0; i < 3; ++i) {
            double sum = albedo.values[0][i];
            for (std::size_t o = 0; o < nodes.size(); ++o) {
                const double u = rule.nodes[static_cast<Eigen::Index>(o)];
                sum += rule.weights[static_cast<Eigen::Index>(o)] * 2 * u * 2 * std::numbers::pi *
                       nodes[o] * lobe.values[0][i * nodes.size() + o];
            }
            EXPECT_NEAR(sum, 1, 3e-6) << ndf;
        }
    }
}

// Cosine-averaged reflectances of dielectrics: exact integrals of Fresnel's formulas to six digits;
// from inside 1 - (1 - F)/n^2.
TEST(Derived, MeanReflectanceOfFacets)
{
    const auto mean = [](const std::string& text) { return mean_reflectance(lobe_of(text), 0); };
    EXPECT_NEAR(mean("ggx f0=0.04"), 0.04 + 0.96 / 21, 1e-12);
    EXPECT_NEAR(mean("ggx fresnel=dielectric eta=1.5"), 0.091778, 5e-7);
    EXPECT_NEAR(mean("ggx fresnel=dielectric eta=1.33"), 0.065931, 5e-7);
    EXPECT_NEAR(mean("ggx fresnel=dielectric eta=3"), 0.276203, 5e-7);
    EXPECT_NEAR(1 - (1 - mean("ggx fresnel=dielectric eta=1.5")) / 2.25, 0.596346, 5e-7);
    EXPECT_NEAR(mean("ggx fresnel=dielectric eta=0.66666666666666667"), 0.596346, 5e-6);
}

// A one-way lobe is not the same from both sides.
TEST(Derived, DirectionsOfAOneWayLobe)
{
    const std::string material =
        "model = \"phong\"\nparameters = { form = \"phong_1975\", rho_s = 1 }";
    const std::string axes = "axes = { mu = { values = [0.3] } }";
    const auto out = made(material, "quantity = \"directional_albedo\"\n" + axes);
    const auto in = made(material, "quantity = \"hemispherical_directional_reflectance\"\n" + axes);
    EXPECT_GT(std::abs(out.values[0][0] - in.values[0][0]), 0.01);
}

// What diffraction takes from the mirror direction is all of the lobe: 1 - e^-g with g fixed by the
// incidence integrates to a closed form as long as the lobe stays above the horizon.
TEST(Derived, MirrorTermAndLobeReflectAllLight)
{
    const std::string material =
        "model = \"harvey_shack\"\nparameters = { form = \"modified\", fresnel = \"schlick\", "
        "f0 = 1, wavelength = 500, sigma = 0.04, tau = 20 }";
    const std::string axes = "axes = { mu = { values = [0.6, 0.8, 1] } }";
    const auto mirror = made(material, "quantity = \"specular_reflectance\"\n" + axes);
    const auto lobe = made(material, "quantity = \"directional_albedo\"\n" + axes);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(mirror.values[0][k] + lobe.values[0][k], 1, 2e-6);
    EXPECT_NEAR(mirror.values[0][2], std::exp(-std::pow(0.16 * std::numbers::pi / 0.5, 2)), 1e-7);
}

// He & al. 1991 lose light to shadowing only at grazing incidence.
TEST(Derived, MirrorTermsOfTheWaveModels)
{
    const std::string numbers =
        "fresnel = \"schlick\", f0 = 0.5, wavelength = 600, sigma = 0.03, tau = 3 }";
    for (const char* model : {"beckmann_kirchhoff", "vernold_harvey", "he_torrance"}) {
        const auto mirror = made(fmt::format("model = \"{}\"\nparameters = {{ {}", model, numbers),
                                 "quantity = \"specular_reflectance\"\n"
                                 "axes = { mu = { values = [0.01, 1] } }");
        EXPECT_NEAR(mirror.values[0][1], 0.5 * std::exp(-std::pow(0.2 * std::numbers::pi, 2)), 1e-7)
            << model;
        const bool shadowed = std::string_view(model) == "he_torrance";
        EXPECT_EQ(mirror.values[0][0] < 0.9, shadowed) << model;
    }
}

TEST(Derived, FilesHoldValuesAndErrors)
{
    const test::TemporaryDirectory directory;
    for (const char* format : {"exr", "npy", "csv"}) {
        Job job =
            jobs_of("model = \"ggx\"",
                    fmt::format("quantity = \"dfg\"\nformat = \"{}\"\n[table.axes]\n"
                                "alpha = {{ values = [0.1, 0.5] }}\nmu = {{ to = 1, count = 3 }}",
                                format))
                .front();
        job.path = directory / fmt::format("t.{}", format);
        make_integrals(Device("", 8), job, [](std::size_t) {});
        const TableHeader header = read_header(job.path);
        EXPECT_EQ(header.channels,
                  (std::vector<std::string>{"scale", "bias", "scale.error", "bias.error"}));
        EXPECT_EQ(header.axes.front().name, "alpha");
        EXPECT_EQ(header.cells(), 6U);
    }
}

TEST(BadIntegral, IsRefusedAtItsPlace)
{
    const auto asked = [](const std::string& lines) {
        return test::bad_table("material = \"steel\"\nquantity = \"directional_albedo\"\n" + lines);
    };
    EXPECT_EQ(asked("axes = { mu = @{ to = 2, count = 4 } }"),
              "`mu` is from 0.25 to 1.75; allowed is 1e-06 to 1, the cosine to the normal");
    EXPECT_EQ(asked("axes = { theta_i = @{ to = 90, count = 4, samples = \"node\" } }"),
              "`theta_i` is from 0 to 90; allowed is 0 to 89.9999 deg");
    EXPECT_EQ(asked("axes = { mu = { to = 1, count = 4 }, aplha = @{ to = 1, count = 4 } }"),
              "`aplha` is no axis of the quantity `directional_albedo`; did you mean `alpha`?");
    EXPECT_EQ(asked("axes = { mu = { to = 1, count = 4 }, alpha = @{ to = 4, count = 2 } }"),
              "`alpha_x` is 3; allowed is 1e-05 to 1");
    EXPECT_EQ(asked("axes = @{ alpha = { to = 1, count = 4 } }"),
              "the quantity `directional_albedo` needs one axis `mu`");
    EXPECT_EQ(asked("photons = @1e6\naxes = { mu = { to = 1, count = 4 } }"),
              "an integral has no `photons`: `max_error` or `time` set how exact it is");
    EXPECT_EQ(asked("time = \"5 s\"\naxes = { mu = { to = 1, count = 4 } }"), "");
    EXPECT_EQ(asked("max_error = 1e-3\naxes = { mu = { to = 1, count = 4 } }"), "");
}

TEST(BadIntegral, IsRefusedForTheMaterial)
{
    const std::string dfg = "quantity = \"dfg\"\naxes = { mu = { to = 1, count = 4 } }";
    const auto message = [&](const std::string& material) -> std::string {
        try {
            jobs_of(material, dfg);
        } catch (const UsageError& fault) {
            return fault.what();
        }
        return {};
    };
    EXPECT_THAT(message("model = \"ward\""), HasSubstr("has no facets with an f0"));
    EXPECT_THAT(message("model = \"ggx\"\nparameters = { fresnel = \"dielectric\" }"),
                HasSubstr("it needs fresnel = \"schlick\""));
    EXPECT_EQ(message("model = \"schlick_1994\""), "");
    EXPECT_THROW(made("model = \"ggx\"",
                      "quantity = \"specular_reflectance\"\naxes = { mu = { to = 1, count = 2 } }"),
                 UsageError);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Generated scenes by the solvers that the plan takes, against others that leave nothing out.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "compute/shared_device.hpp"
#include "gonio/errors.hpp"
#include "photon/asked_layers.hpp"
#include "photon/exact_values.hpp"
#include "photon/photon_fixtures.hpp"
#include "quadrature/derived.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/albedo.hpp"
#include "skin/skin_table.hpp"

namespace gonio::test {
namespace {

class SolverCorpus : public SharedDevice {
protected:
    ~SolverCorpus() override { std::filesystem::remove_all(directory); }

    double even(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random);
    }

    Job job(const std::string& material, const std::string& table) const
    {
        return plan_jobs(parse_scene("[[material]]\nname = \"m\"\n" + material +
                                         "\n[[table]]\nmaterial = \"m\"\n" + table,
                                     "s.toml"),
                         directory)
            .front();
    }

    std::mt19937_64 random{11};
    std::filesystem::path directory =
        std::filesystem::temp_directory_path() / "gonio-solver-corpus";
};

/// Three layers, the middle one sometimes clear, lit along the normal: reflected light by
/// adding-doubling without what the plan leaves out, and by photons through all of it.
TEST_F(SolverCorpus, LayersAgreeWithPhotons)
{
    constexpr std::uint64_t photons = 1 << 13;
    constexpr double asked = 1e-3;
    ZTest test;
    std::size_t left_out = 0;
    for (int k = 0; k < 40; ++k) {
        std::vector<std::string> layers;
        for (int at = 0; at < 3; ++at)
            layers.push_back(at == 1 && k % 3 == 0
                                 ? std::string("{ n = 1.4, d = 0.1 }")
                                 : fmt::format("{{ mua = {}, mus = {}, g = {}, n = {}, d = {} }}",
                                               std::pow(10, even(-1, 1.3)),
                                               std::pow(10, even(0.5, 2)), even(0, 0.9),
                                               k % 2 == 0 ? 1.4 : even(1.3, 1.5),
                                               std::pow(10, even(-1.5, 0.3))));
        const Job planned =
            job(fmt::format("layers = [{}]", fmt::join(layers, ", ")),
                "quantity = \"directional_albedo\"\naxes = { mu = { values = [1] } }\n"
                "max_error = 1e-3\n");
        ASSERT_EQ(planned.layers->solver, "adding_doubling");
        LightJob light = *planned.layers;
        light.medium = asked_layers(planned).medium;
        left_out += planned.layers->medium.layers.size() - light.medium.layers.size();
        const Fraction albedo = exact_values(light, planned.header.axes).values.front();
        EXPECT_LE(albedo.error, asked);
        PhotonTracer tracer(*device(), planned.layers->medium, photon_request(photons));
        tracer.trace(photons);
        const PhotonResult traced = tracer.result();
        const Fraction& diffuse = traced.diffuse_reflectance;
        test.add(fmt::format("stack {}", k), {diffuse.mean, std::hypot(diffuse.error, asked)},
                 albedo.mean - traced.specular.mean, photons);
    }
    test.expect_only_noise();
    EXPECT_GT(left_out, 20U);
}

/// Sums of lobes, half of which reflect nothing, against the reference's quadrature of the sum.
TEST_F(SolverCorpus, IntegralsAgreeWithTheReference)
{
    for (int k = 0; k < 24; ++k) {
        const std::string lobes = fmt::format(
            "lobes = [ {{ model = \"lambert\", parameters = {{ rho = {} }} }}, "
            "{{ model = \"ggx\", weight = {}, parameters = {{ alpha = {} }} }}, "
            "{{ model = \"cook_torrance\", parameters = {{ fresnel = \"dielectric\", eta = 1 }} }} "
            "]",
            k % 3 == 0 ? 0 : even(0, 1), k % 3 == 1 ? 0 : 0.4, even(0.2, 1));
        const Job integral = job(lobes, fmt::format("quantity = \"directional_albedo\"\n"
                                                    "axes = {{ mu = {{ values = [{}] }} }}\n"
                                                    "max_error = 1e-5\n",
                                                    even(0.1, 1)));
        const DerivedTable found = derive(*device(), integral);
        const Reference f = make_reference(integral.materials.front(), Measure::brdf);
        const double right =
            reference::directional_albedo(f, unit_vector(integral.cells.front().at), 0, 2e-6);
        EXPECT_NEAR(found.values[0][0], right, found.values[1][0] + 1e-5) << lobes;
    }
}

/// Sets of skin share layers at a wavelength; here each is solved alone.
TEST_F(SolverCorpus, SkinAgreesWithItsLayersOneByOne)
{
    for (const char* model : {"jacques_1998", "meglinski_2002"}) {
        const Job spectra =
            job(fmt::format("skin = \"{}\"\nparameters = {{ melanin = {{ values = [0.02, 0.1] }}, "
                            "blood = {{ values = [0.002, 0.01] }} }}",
                            model),
                "quantity = \"reflectance_spectrum\"\nformat = \"npy\"\nmax_error = 1e-4\n"
                "axes = { wavelength = { values = [450, 560, 700] } }\n");
        std::filesystem::create_directories(directory);
        make_skin_table(spectra);
        const Table table = read_table(spectra.path);
        std::size_t cell = 0;
        Skin skin = spectra.skin->skin;
        for (const double melanin : spectra.skin->ladders[0].values)
            for (const double blood : spectra.skin->ladders[1].values)
                for (const double wavelength : {450.0, 560.0, 700.0}) {
                    skin.set(spectra.skin->ladders[0].parameter, melanin);
                    skin.set(spectra.skin->ladders[1].parameter, blood);
                    const auto alone = reference::solve_layers_to(skin.layers_at(wavelength),
                                                                  {.incidence = {0}}, 1e-4);
                    const auto& budget = alone.collimated[0].budget;
                    EXPECT_NEAR(table.values[0][cell++],
                                budget.specular + budget.diffuse_reflectance, 2e-4)
                        << model << ' ' << melanin << ' ' << blood << ' ' << wavelength;
                }
    }
}

}  // namespace
}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// R(r) of skin at wavelengths that share photons.
#include <gtest/gtest.h>

#include <cmath>

#include "gonio/errors.hpp"
#include "gonio/profile.hpp"
#include "opencl/photon_kernel.hpp"
#include "photon/bins.hpp"
#include "reference/z_test.hpp"
#include "skin/spectral_bases.hpp"

namespace gonio {
namespace {

constexpr std::uint64_t photons = 1 << 14;
constexpr double width = 0.02;  // cm
constexpr std::size_t rings = 5;

/// Of the wavelength alone.
PhotonResult separate_run(const Skin& skin, double wavelength)
{
    PhotonRequest request{.seed = 5, .batch = batch_of(photons)};
    request.tallies = {.reflected = true, .radius_width = width, .rows = rings, .spectrum = {}};
    PhotonTracer tracer(Device(), skin.layers_at(wavelength), request);
    tracer.trace(photons);
    return tracer.result();
}

void add_totals(test::ZTest& noise, const Skin& skin, const std::vector<double>& wavelengths,
                const RadialSpectrum& spectrum)
{
    const auto exact = solve_skin({skin}, wavelengths, {}, 1e-5)[0];
    for (std::size_t k = 0; k < wavelengths.size(); ++k)
        noise.add(skin.model().id + " total " + std::to_string(wavelengths[k]),
                  {spectrum.total[k].mean, spectrum.total[k].error},
                  exact.reflectance[k] - exact.specular[k], photons);
}

// Separate photons at blue, at both ends of the W of haemoglobin, and at red; rings hold a thousand
// photons and more, so that their noise is normal.
TEST(RadialSpectrum, IsThatOfSeparateRuns)
{
    const Skin skin(find_skin_model("meglinski_2002"));
    const std::vector<double> wavelengths = {400, 450, 542, 577, 650, 760};
    const auto spectrum = trace_spectrum(Device(), skin, wavelengths,
                                         {.width = width, .rings = rings, .photons = 16 * photons});
    EXPECT_EQ(spectrum.photons, std::vector{16 * photons});
    test::ZTest noise;
    for (std::size_t k = 0; k < wavelengths.size(); ++k) {
        const PhotonResult alone = separate_run(skin, wavelengths[k]);
        for (std::size_t ring = 0; ring < rings; ++ring) {
            const Fraction &shared = spectrum.rings[k][ring], &own = alone.reflected[ring];
            noise.add(std::to_string(wavelengths[k]) + " ring " + std::to_string(ring),
                      {shared.mean, std::hypot(shared.error, own.error)}, own.mean, photons);
        }
        EXPECT_GT(spectrum.effective_photons[k], 0.1 * 16 * photons);
        EXPECT_LT(spectrum.effective_photons[k], 16 * photons);
    }
    add_totals(noise, skin, wavelengths, spectrum);
    noise.expect_only_noise();
}

TEST(RadialSpectrum, HasTheExactTotalsWhereScatteringChanges)
{
    std::vector<double> wavelengths;
    for (int at = 380; at <= 780; at += 10) wavelengths.push_back(at);
    const Skin skin(find_skin_model("jacques_1998"));
    const auto spectrum = trace_spectrum(Device(), skin, wavelengths,
                                         {.width = width, .rings = rings, .photons = photons});
    EXPECT_LT(spectrum.photons.size(), 10U);
    test::ZTest noise;
    add_totals(noise, skin, wavelengths, spectrum);
    noise.expect_only_noise();
}

TEST(RadialSpectrum, EndsWhereItIsExactEnough)
{
    const Skin skin(find_skin_model("meglinski_2002"));
    ProfileRequest request{.width = 0.1, .rings = 2, .photons = 1 << 30, .max_error = 0.05};
    const auto spectrum = trace_spectrum(Device(), skin, {450, 650}, request);
    EXPECT_LT(spectrum.photons[0], 40'000U);
    for (const auto& light : spectrum.rings) EXPECT_LT(light[0].error, 0.05 * light[0].mean);
    request.max_error = 0;
    request.photons = 4321;
    EXPECT_EQ(trace_spectrum(Device(), skin, {450, 650}, request).photons[0], 4321U);
}

// Between bases errors are larger than theirs.
TEST(RadialSpectrum, EndsWhereAllWavelengthsAreExactEnough)
{
    std::vector<double> wavelengths;
    for (int at = 400; at <= 700; at += 5) wavelengths.push_back(at);
    const Skin skin(find_skin_model("pyxopto"));
    const ProfileRequest request{
        .width = 0.01, .rings = 20, .photons = 1 << 30, .max_error = 0.018};
    const auto spectrum = trace_spectrum(Device(), skin, wavelengths, request);
    EXPECT_LT(spectrum.photons.size(), 10U);
    for (const auto& light : spectrum.rings)
        EXPECT_LE(largest_error(ring_densities(light, request.width)), 0.018);
}

TEST(RadialSpectrum, EndsInTime)
{
    const Skin skin(find_skin_model("meglinski_2002"));
    ProfileRequest request{.width = 0.1, .rings = 2, .photons = 1 << 30, .seconds = 0};
    const auto first = trace_spectrum(Device(), skin, {450, 650}, request);
    EXPECT_EQ(first.photons[0], 2048U);  // two batches tell an error
    EXPECT_TRUE(std::isfinite(first.rings[0][0].error));
    request.seconds = 0.2;
    EXPECT_GT(trace_spectrum(Device(), skin, {450, 650}, request).photons[0], 2048U);
    EXPECT_GT(trace_profile(Device(), bands_of(skin), request).photons, 2048U);
}

// Blue light goes less far, and gets photons of its own, which are more.
TEST(RadialSpectrum, EndsWhereEachRingIsExactEnough)
{
    const Skin skin(find_skin_model("meglinski_2002"));
    const ProfileRequest request{
        .width = width, .rings = rings, .photons = 1 << 30, .ring_error = 0.1};
    const auto even = trace_spectrum(Device(), skin, {415, 500, 650}, request);
    EXPECT_EQ(even.photons.size(), 1U);  // up to 1 mm they are worth something to each other
    const ProfileRequest farther{
        .width = 2 * width, .rings = rings, .photons = 1 << 30, .ring_error = 0.1};
    const auto spectrum = trace_spectrum(Device(), skin, {415, 500, 650}, farther);
    ASSERT_EQ(spectrum.photons.size(), 2U);
    EXPECT_GT(spectrum.photons[1], 2 * spectrum.photons[0]);
    test::ZTest noise;
    add_totals(noise, skin, {415, 500, 650}, spectrum);
    noise.expect_only_noise();
    for (const auto& light : spectrum.rings) EXPECT_LE(mean_relative_error(light), 0.1);
}

// Weights of interpolation add up to 1, for the rule with one base less too; no photon gets
// heavier.
TEST(SpectralBases, ServeEveryWavelength)
{
    const auto wavelengths = default_wavelengths();
    for (const std::string& model : skin_model_names()) {
        if (model == "meglinski_2001") continue;  // known at 600 nm only
        std::vector<double> weights(wavelengths.size()), coarser(wavelengths.size());
        const auto bases =
            spectral_bases(media_of(Skin(find_skin_model(model)), wavelengths), {0.2, 0.2});
        EXPECT_LE(bases.size(), 40U) << model;
        for (const SpectralBase& base : bases)
            for (std::size_t k = 0; k < base.shares.size(); ++k) {
                weights[base.shares[k].medium] += base.shares[k].weight;
                coarser[base.shares[k].medium] += base.shares[k].coarser;
                for (const double more : base.more_absorption[k]) EXPECT_GE(more, 0);
            }
        for (std::size_t k = 0; k < wavelengths.size(); ++k) {
            EXPECT_NEAR(weights[k], 1, 1e-12) << model << " " << wavelengths[k];
            EXPECT_NEAR(coarser[k], 1, 1e-12) << model << " " << wavelengths[k];
        }
    }
}

/// The device's sums of a spectrum, in launches.
std::vector<std::uint64_t> sums(unsigned wide, const std::vector<std::uint32_t>& launches,
                                PhotonWork work = {})
{
    const auto base =
        spectral_bases(media_of(Skin(find_skin_model("meglinski_2002")), {400, 550, 700}))[0];
    PhotonRequest request;
    request.tallies.rows = rings;
    request.tallies.spectrum = base.more_absorption;
    PhotonKernel kernel(Device("", wide), photon_program(base.medium, request), 3, work);
    std::uint64_t next = 0;
    for (const std::uint32_t count : launches) {
        kernel.run(next, count);
        next += count;
    }
    return kernel.take_sums();
}

TEST(SpectralSums, AreTheSameHoweverTheWorkIsDivided)
{
    const auto whole = sums(8, {2000});
    for (const unsigned wide : {1U, 16U}) EXPECT_EQ(sums(wide, {2000}), whole) << wide;
    EXPECT_EQ(sums(8, {1, 999, 1000}), whole);
    EXPECT_EQ(sums(8, {2000}, {.items = 64, .shared_tallies = true}), whole);
}

TEST(SpectralSums, RefuseWhatNoPhotonCanHave)
{
    LayeredMedium medium = Skin(find_skin_model("jacques_1998")).layers_at(500);
    PhotonRequest request;
    request.tallies.spectrum = {{1, -1}};
    EXPECT_THROW(PhotonTracer(Device(), medium, request), UsageError);
    request.tallies.spectrum = {{1}};
    EXPECT_THROW(PhotonTracer(Device(), medium, request), UsageError);
    request.tallies.spectrum = {{1, 1}};
    request.tallies.row = ExitRow::time;
    EXPECT_THROW(PhotonTracer(Device(), medium, request), UsageError);
}

}  // namespace
}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The same sums, to the last bit, however the work is divided.
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "gonio/errors.hpp"
#include "opencl/photon_kernel.hpp"
#include "photon/photon_fixtures.hpp"
#include "reference/layered_media.hpp"

namespace gonio::test {
namespace {

constexpr std::uint32_t photons = 3000;
constexpr std::uint64_t first = (std::uint64_t{1} << 32) - 1000;  // the lower half overflows

PhotonProgram program()
{
    LayeredMedium medium = mcml_sample();
    medium.layers[0].n = 1.5;
    medium.layers[1].phase = TwoTermHenyeyGreenstein{0.8, -0.3, 0.6};
    medium.layers[2].phase = Rayleigh{};
    medium.layers.insert(medium.layers.begin(), layer(1.3, 0, 0, 0, 0.01));
    medium.bottom = Bottom::diffuse;
    medium.bottom_albedo = 0.5;
    PhotonRequest request;
    request.light.beam = Beam::diffuse;
    request.tallies = {.reflected = true,
                       .absorbed = true,
                       .rows = 10,
                       .angles = 9,
                       .depths = 10,
                       .absorbed_radii = 10};
    return photon_program(medium, request);
}

/// What the other program has not: a wide beam, a tabulated phase function, rows of time.
PhotonProgram timed_program()
{
    LayeredMedium medium = mcml_sample();
    medium.layers[1].phase = TabulatedPhase{{-1, 0, 0.9, 1}, {1, 0, 1, 20}};
    PhotonRequest request;
    request.light = {.beam = Beam::gaussian, .incidence = 0.5, .radius = 0.1};
    request.tallies = {.reflected = true,
                       .transmitted = true,
                       .row = ExitRow::time,
                       .time_width = 2,
                       .rows = 20,
                       .angles = 3};
    return photon_program(medium, request);
}

std::vector<std::uint64_t> sums(unsigned width, PhotonWork work = {},
                                std::vector<std::uint32_t> launches = {photons},
                                const PhotonProgram& what = program())
{
    PhotonKernel kernel(Device("", width), what, 7, work);
    std::uint64_t next = first;
    for (const std::uint32_t count : launches) {
        kernel.run(next, count);
        next += count;
    }
    return kernel.take_sums();
}

TEST(PhotonSums, AreTheSameAtEveryWidth)
{
    const auto narrow = sums(1);
    for (const unsigned width : {2U, 4U, 8U, 16U}) EXPECT_EQ(sums(width), narrow) << width;
    EXPECT_EQ(sums(16, {}, {photons}, timed_program()), sums(1, {}, {photons}, timed_program()));
}

TEST(PhotonSums, AreTheSameForEveryDivision)
{
    const auto whole = sums(8);
    for (const std::size_t items : {1U, 3U, 64U})
        EXPECT_EQ(sums(8, {.items = items}), whole) << items;
    EXPECT_EQ(sums(8, {.items = 64, .shared_tallies = true}), whole);
    EXPECT_EQ(sums(8, {}, {1000, 1, 999, 500, 500}), whole);
    EXPECT_NE(sums(8, {}, {photons - 1}), whole);
}

TEST(PhotonSums, GoOnFromASavedState)
{
    PhotonRequest request;
    request.batch = 10'000;  // of several launches
    PhotonTracer whole(Device(), mcml_sample(), request);
    whole.trace(30'000);
    std::string state;
    std::uint64_t traced = 0;
    PhotonTracer broken_off(Device("", 1), mcml_sample(), request);
    try {
        broken_off.trace(25'000, [&](std::uint64_t count) {
            traced += count;
            state = broken_off.state();
            throw std::runtime_error("interrupted");
        });
    } catch (const std::runtime_error&) {
    }
    PhotonTracer second(Device(), mcml_sample(), request);
    second.restore(state);
    second.trace(30'000 - traced);
    EXPECT_EQ(second.result().diffuse_reflectance.mean, whole.result().diffuse_reflectance.mean);
    EXPECT_EQ(second.result().diffuse_reflectance.error, whole.result().diffuse_reflectance.error);
    EXPECT_THROW(second.restore("no state"), UsageError);
    request.tallies.reflected = true;
    request.tallies.rows = 3;
    PhotonTracer other(Device(), mcml_sample(), request);
    EXPECT_THROW(other.restore(state), UsageError);
}

TEST(PhotonSums, AreTheSameForEveryBatch)
{
    PhotonRequest request;
    request.batch = 1000;
    const PhotonResult whole = simulate_photons(mcml_sample(), request, 5500);
    PhotonTracer tracer(Device(), mcml_sample(), request);
    for (const std::uint64_t count : {3000U, 2500U}) tracer.trace(count);
    EXPECT_EQ(tracer.result().diffuse_reflectance.mean, whole.diffuse_reflectance.mean);
    EXPECT_EQ(tracer.result().photons, 5500U);
    request.batch = 700;
    EXPECT_EQ(simulate_photons(mcml_sample(), request, 5500).diffuse_reflectance.mean,
              whole.diffuse_reflectance.mean);
    request.seed = 2;
    EXPECT_NE(simulate_photons(mcml_sample(), request, 5500).diffuse_reflectance.mean,
              whole.diffuse_reflectance.mean);
}

}  // namespace
}  // namespace gonio::test

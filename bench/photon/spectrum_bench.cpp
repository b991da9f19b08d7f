// SPDX-License-Identifier: Apache-2.0
// R(r) of skin at 81 wavelengths in ten rings up to 2 mm, photons that wavelengths share against a
// run for each with the same kernel: kernel time for an error of 0.5 % at every wavelength. Errors
// are the largest over the largest value, as max_error; `of_rings` takes the root of the mean
// square of all rings' relative errors, as ring_error, which those of blue light at 2 mm rule.
//   shared_s, separate_s  time
//   gain, gain_of_rings   one over the other; the latter with photons to a ring_error
//   bases                 whose photons are shared
//   effective             photons that a wavelength has seen are worth so many of its own, the
//   least
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "gonio/profile.hpp"
#include "photon/bins.hpp"

namespace gonio {
namespace {

constexpr double wanted = 0.005, width = 0.02;  // cm
constexpr std::size_t rings = 10;

struct Squares {
    double of_largest = 0, of_rings = 0;
};

/// Squared errors over that which is wanted.
Squares square_errors(const std::vector<Fraction>& light)
{
    // Without what leaves beyond them.
    const std::vector<Fraction> inner(light.begin(), light.begin() + rings);
    return {std::pow(largest_error(ring_densities(inner, width)) / wanted, 2),
            std::pow(mean_relative_error(inner) / wanted, 2)};
}

void spectrum(benchmark::State& state, const std::string& model)
{
    const Device device;
    const Skin skin(find_skin_model(model));
    const auto wavelengths = default_wavelengths();
    constexpr std::uint64_t shared_photons = 1 << 18, photons = 1 << 15;
    for (auto _ : state) {
        const auto shared = trace_spectrum(
            device, skin, wavelengths, {.width = width, .rings = rings, .photons = shared_photons});
        const auto by_rings = trace_spectrum(
            device, skin, wavelengths,
            {.width = width, .rings = rings, .photons = 1 << 23, .ring_error = 4 * wanted});
        Squares separate, most;  // times; the most of any wavelength
        for (std::size_t k = 0; k < wavelengths.size(); ++k) {
            PhotonRequest request{.batch = batch_of(photons)};
            request.tallies = {
                .reflected = true, .radius_width = width, .rows = rings, .spectrum = {}};
            PhotonTracer tracer(device, skin.layers_at(wavelengths[k]), request);
            tracer.trace(photons);
            const Squares alone = square_errors(tracer.result().reflected);
            separate.of_largest += tracer.kernel_seconds() * alone.of_largest;
            separate.of_rings += tracer.kernel_seconds() * alone.of_rings;
            most.of_largest = std::max(most.of_largest, square_errors(shared.rings[k]).of_largest);
            most.of_rings = std::max(most.of_rings, square_errors(by_rings.rings[k]).of_rings);
        }
        const double time = shared.kernel_seconds;
        state.counters["shared_s"] = time * most.of_largest;
        state.counters["separate_s"] = separate.of_largest;
        state.counters["gain"] = separate.of_largest / (time * most.of_largest);
        state.counters["gain_of_rings"] =
            separate.of_rings / (by_rings.kernel_seconds * most.of_rings);
        state.counters["bases"] = static_cast<double>(shared.photons.size());
        state.counters["effective"] =
            std::ranges::min(shared.effective_photons) / double{shared_photons};
    }
}

const bool registered = [] {
    for (const std::string model : {"meglinski_2002", "jacques_1998"})
        benchmark::RegisterBenchmark(("spectrum/" + model).c_str(),
                                     [model](benchmark::State& state) { spectrum(state, model); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace gonio

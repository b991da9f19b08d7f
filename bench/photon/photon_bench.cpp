// SPDX-License-Identifier: Apache-2.0
// Photons through the media of bench/scenes/mcml.mci, with totals and R(r). Variants run one after
// the other in every iteration; medians.
//   photons_per_core  photons a second and compute unit, roulette below 2^-7 as by default
//   at_1e_4           the same with MCML's roulette below 1e-4
//   vs_scalar         that, times the scalar reference on one core
//   vs_mcml, vs_pyxopto, vs_mcx_cl
//                     that, times other programs a core: what they reach of the scalar reference
//   vs_width_1        times the same kernel at width 1
//   cores             all compute units, times one of them
//   with_absorption   time with A(r, z) besides, over time without
//   roulette_gain     1 / (variance of Rd times time), over that with roulette below 1e-4
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "gonio/photons.hpp"
#include "opencl/photon_kernel.hpp"
#include "photon/mci.hpp"
#include "reference/scalar_monte_carlo.hpp"
#include "stopwatch.hpp"

namespace gonio {
namespace {

constexpr double mcml_roulette = 1e-4;

/// Other programs, photons a second and core, beside each other on a Zen 4 server of 2.6 GHz: MCML
/// 1.2.2 and 2.0.1 (gcc -O3 -march=native -ffast-math -flto, with A(r, z)), PyXOpto (float,
/// without) and MCX-CL (voxels), these two on PoCL 3.1.
struct Others {
    double mcml_1, mcml_2, pyxopto, mcx_cl;
    /// MCML 1.2.2, times the scalar reference beside it on a Zen 5 server of 2.6 GHz: carries the
    /// rates of the others to the machine of this run.
    double mcml_1_vs_scalar;
};

const std::map<std::string, Others> others = {
    {"slab.mco", {3.20e6, 3.53e6, 2.53e6, 3.08e5, 1.64}},
    {"sample.mco", {2.04e5, 2.19e5, 1.57e5, 3.15e4, 1.61}},
    {"skin.mco", {2.01e4, 2.16e4, 1.72e4, 1.86e3, 1.67}},
    {"giovanelli.mco", {3.01e5, 3.07e5, 2.27e5, 5.07e4, 1.59}},
    {"skin5.mco", {7.95e4, 8.24e4, 6.34e4, 7.37e3, 1.58}},
};

double median(std::vector<double> values)
{
    std::ranges::nth_element(values, values.begin() + std::ssize(values) / 2);
    return values[values.size() / 2];
}

/// A kernel with its options, and the photons a second that it reached.
class Variant {
public:
    Variant(const Device& device, const MciRun& run, double roulette, bool absorbed,
            std::size_t items = 0)
        : kernel_(device, program(run, roulette, absorbed), 1, {.items = items})
    {
        // Long enough to measure, and to build it.
        while (kernel_.run(0, count_) < 0.1) count_ *= 2;
    }

    void measure() { rates_.push_back(count_ / kernel_.run(0, count_)); }
    double rate() const { return median(rates_); }

private:
    static PhotonProgram program(const MciRun& run, double roulette, bool absorbed)
    {
        PhotonRequest request{.tallies = run.tallies, .roulette_below = roulette};
        request.tallies.transmitted = false;
        request.tallies.angles = 1;
        request.tallies.absorbed = absorbed;
        return photon_program(run.medium, request);
    }

    PhotonKernel kernel_;
    std::uint32_t count_ = 1024;
    std::vector<double> rates_;
};

/// The scalar reference, on one core.
class Scalar {
public:
    explicit Scalar(const MciRun& run) : medium_(run.medium)
    {
        while (seconds() < 0.1) photons_ *= 2;
    }

    void measure() { rates_.push_back(static_cast<double>(photons_) / seconds()); }
    double rate() const { return median(rates_); }

private:
    double seconds() const
    {
        const Stopwatch watch;
        benchmark::DoNotOptimize(reference::simulate(medium_, {.photons = photons_}));
        return watch.seconds();
    }

    LayeredMedium medium_;
    std::size_t photons_ = 1000;
    std::vector<double> rates_;
};

/// Of the score of one photon.
double variance(const Device& device, const MciRun& run, double roulette)
{
    constexpr std::uint64_t photons = 1 << 16, batch = 1 << 7;
    PhotonTracer tracer(device, run.medium, {.batch = batch, .roulette_below = roulette});
    tracer.trace(photons);
    const double error = tracer.result().diffuse_reflectance.error;
    return error * error * photons;
}

void photons(benchmark::State& state, const MciRun& run)
{
    const Device device, narrow("", 1);
    const double preset = PhotonRequest().roulette_below;
    Variant usual(device, run, preset, false), deep(device, run, mcml_roulette, false),
        single(device, run, preset, false, 1), thin(narrow, run, preset, false),
        absorbed(device, run, preset, true);
    Scalar scalar(run);
    for (auto _ : state) {
        for (Variant* variant : {&usual, &deep, &single, &thin, &absorbed}) variant->measure();
        scalar.measure();
    }
    const double cores = device.info().compute_units;
    const double variances = variance(device, run, mcml_roulette) / variance(device, run, preset);
    state.SetLabel(device.info().name + ", vector width " + std::to_string(device.width()));
    state.counters["photons_per_core"] = usual.rate() / cores;
    state.counters["at_1e_4"] = deep.rate() / cores;
    const double vs_scalar = deep.rate() / cores / scalar.rate();
    const Others& other = others.at(run.output);
    const double vs_mcml_1 = vs_scalar / other.mcml_1_vs_scalar;
    state.counters["vs_scalar"] = vs_scalar;
    state.counters["vs_mcml"] = vs_mcml_1 * other.mcml_1 / other.mcml_2;
    state.counters["vs_pyxopto"] = vs_mcml_1 * other.mcml_1 / other.pyxopto;
    state.counters["vs_mcx_cl"] = vs_mcml_1 * other.mcml_1 / other.mcx_cl;
    state.counters["vs_width_1"] = usual.rate() / thin.rate();
    state.counters["cores"] = usual.rate() / single.rate();
    state.counters["with_absorption"] = usual.rate() / absorbed.rate();
    state.counters["roulette_gain"] = variances * usual.rate() / deep.rate();
}

const bool registered = [] {
    for (const MciRun& run : load_mci(SCENES "/mcml.mci"))
        benchmark::RegisterBenchmark(("photons/" + run.output).c_str(),
                                     [run](benchmark::State& state) { photons(state, run); })
            ->Iterations(7)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace gonio

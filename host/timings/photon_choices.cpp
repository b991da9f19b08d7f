// SPDX-License-Identifier: Apache-2.0
// What the choices of the photon kernel gain: time of a photon and error that it brings.
#include <fmt/format.h>

#include <cmath>

#include "gonio/photons.hpp"
#include "opencl/photon_kernel.hpp"
#include "reference/scalar_monte_carlo.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

/// A photon kernel that runs for about a tenth of a second.
class Timed {
public:
    Timed(const Device& device, const PhotonRequest& request)
        : kernel_(device, photon_program(benchmark_skin(), request), request.seed)
    {
        while (kernel_.run(0, count_) < 0.05) count_ *= 2;
    }

    double microseconds_each() { return kernel_.run(0, count_) * 1e6 / count_; }

private:
    PhotonKernel kernel_;
    std::uint32_t count_ = 1024;
};

/// Of the diffuse reflectance by one photon, over its mean.
double error_of_one(const Device& device, PhotonRequest request, std::uint64_t photons)
{
    request.batch = 64;
    PhotonTracer tracer(device, benchmark_skin(), request);
    tracer.trace(photons);
    const Fraction rd = tracer.result().diffuse_reflectance;
    return rd.error / rd.mean * std::sqrt(double(photons));
}

BenchPoint scalar(const BenchRun& run, bool analogue)
{
    const std::size_t photons = run.quick ? 2000 : 50'000;
    reference::Estimate rd;
    const auto simulate = [&] {
        rd = reference::simulate(benchmark_skin(), {.photons = photons,
                                                    .roulette_below = 0x1p-7,
                                                    .analogue = analogue,
                                                    .r_bins = 1,
                                                    .z_bins = 1})
                 .diffuse_reflectance;
    };
    const auto each = [&] { return seconds_on_the_wall(simulate) * 1e6 / double(photons); };
    const Quartiles took = interleaved({each}, run.quick ? 1 : 3).front();
    return {"scalar reference, one core", analogue ? "analogue absorption" : "absorption by weight",
            took, exactly(rd.error / rd.mean * std::sqrt(double(photons)))};
}

}  // namespace

BenchPlot bench_photon_choices(const BenchRun& run)
{
    BenchPlot plot{
        "choices", "What a photon costs, and what it brings",
        "The skin of the photons' plot, totals only. The smaller the square of the error "
        "times the time, the better; widths do not change the error. All units of the "
        "device; the scalar reference has one core.",
        "microseconds per photon", "standard error of Rd by one photon, relative"};
    const std::uint64_t photons = std::uint64_t{1} << (run.quick ? 15 : 18);
    std::vector<Candidate> candidates;
    const auto add = [&](const std::string& series, const std::string& label, const Device& device,
                         const PhotonRequest& request) {
        run.step(fmt::format("choices: {} {}", series, label));
        const auto kernel = std::make_shared<Timed>(device, request);
        candidates.push_back({{series, label, {}, exactly(error_of_one(device, request, photons))},
                              [kernel] { return kernel->microseconds_each(); }});
    };
    for (const unsigned width : {1U, 4U, 8U, 16U})
        add("vector width", std::to_string(width), run.at_width(width), {});
    for (const int power : {3, 5, 7, 10, 14})
        add("roulette below", fmt::format("2^-{}", power), run.device,
            {.roulette_below = std::pow(2.0, -power)});
    time_in_turn(plot, std::move(candidates), run.rounds());
    for (const bool analogue : {false, true}) {
        run.step("choices: absorption");
        plot.points.push_back(scalar(run, analogue));
    }
    return plot;
}

}  // namespace gonio

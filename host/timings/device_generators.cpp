// SPDX-License-Identifier: Apache-2.0
// Random numbers on the device: how fast the photon kernel is with a generator, and whether it
// bends the answer.
#include <fmt/format.h>

#include "gonio/shared/photon_fields.h"
#include "opencl/photon_kernel.hpp"
#include "photon/weight_sums.hpp"
#include "timings/five_layers.hpp"
#include "timings/sections.hpp"

namespace gonio {
namespace {

/// The photon kernel with one of the streams of kernels/core/streams.
class Streaming {
public:
    Streaming(const Device& device, const std::string& preamble, std::uint32_t batch)
        : kernel_(device, with(preamble), 12345), batch_(batch), sums_(kernel_.program().sums)
    {
    }

    double microseconds_each()
    {
        const double seconds = kernel_.run(sums_.photons(), batch_);
        sums_.add_batch(kernel_.take_sums(), batch_);
        return seconds * 1e6 / batch_;
    }

    Fraction diffuse_transmittance() const { return sums_.fraction(total_transmitted); }

private:
    static PhotonProgram with(const std::string& preamble)
    {
        PhotonProgram program = photon_program(five_layers(), {});
        program.preamble = preamble + program.preamble;
        return program;
    }

    PhotonKernel kernel_;
    std::uint32_t batch_;
    WeightSums sums_;
};

}  // namespace

BenchPlot bench_device_generators(const BenchRun& run)
{
    BenchPlot plot{
        "device-generators", "Random numbers on the device: speed, and what they do to the answer",
        "The photon kernel through the same layers with each generator: the engine's own, a block "
        "of Philox for every step, and two that Philox seeds for each photon. On all units of the "
        "device.",
        "microseconds per photon", "off by, standard errors"};
    plot.joined = plot.x_logarithmic = plot.y_logarithmic = false;
    const std::string by_step = "#include \"core/streams/philox_by_step.cl\"\n";
    const std::vector<std::pair<std::string_view, std::string>> streams{
        {"xoshiro128++ seeded by Philox", ""},
        {"Philox4x32-10 by step", by_step},
        {"Philox4x32-7 by step", "#define STEP_ROUNDS 7\n" + by_step},
        {"PCG32 seeded by Philox", "#include \"core/streams/pcg.cl\"\n"},
        {"multiply with carry, seeded by Philox",
         "#include \"core/streams/multiply_with_carry.cl\"\n"},
    };
    const std::uint32_t batch = run.quick ? 2048 : 65'536;
    std::vector<std::function<double()>> runs;
    std::vector<std::shared_ptr<Streaming>> all;
    for (const auto& [name, preamble] : streams) {
        run.step(fmt::format("device-generators: {}", name));
        const auto stream =
            all.emplace_back(std::make_shared<Streaming>(run.device, preamble, batch));
        runs.emplace_back([stream] { return stream->microseconds_each(); });
    }
    const std::vector<Quartiles> speeds = interleaved(runs, generator_batches);
    const double right = right_transmittance();
    for (std::size_t k = 0; k < streams.size(); ++k)
        plot.points.push_back(compared(streams[k].first, generator_batches * batch, speeds[k],
                                       all[k]->diffuse_transmittance(), right));
    return plot;
}

}  // namespace gonio

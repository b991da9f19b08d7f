// SPDX-License-Identifier: Apache-2.0
// Runs the photon kernel in launches, adds up batches, and sees that no weight is lost.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "gonio/errors.hpp"
#include "gonio/photons.hpp"
#include "gonio/shared/photon_fields.h"
#include "opencl/photon_kernel.hpp"
#include "photon/program.hpp"
#include "photon/weight_sums.hpp"

namespace gonio {
namespace {

constexpr double launch_seconds = 0.15;
constexpr std::uint32_t first_launch = 4096, largest_launch = std::uint32_t{1} << 30;

/// Everything that photons brought in, and nothing else, is where it ended.
void require_balance(const std::vector<std::uint64_t>& sums, std::size_t layers,
                     std::uint64_t photons, const DeviceInfo& device)
{
    const auto begin = sums.begin();
    const std::uint64_t ended =
        std::accumulate(begin, begin + total_gave, std::uint64_t{0}) +
        std::accumulate(begin + photon_totals,
                        begin + photon_totals + static_cast<std::ptrdiff_t>(layers),
                        std::uint64_t{0});
    const std::uint64_t came = photons * whole_photon + sums[total_gave];
    if (ended == came) return;
    throw CheckFailed(
        fmt::format("photons on {} ({}) brought in a weight of {} and {} of it ended somewhere: "
                    "the device or its driver computes wrong numbers",
                    device.name, device.driver, came, ended));
}

}  // namespace

struct PhotonTracer::State {
    Device device;
    PhotonRequest request;
    std::size_t layers;
    PhotonKernel kernel;
    WeightSums sums;
    std::uint64_t next;                ///< number of the next photon
    std::uint64_t in_batch = 0;        ///< photons since the last batch was added
    std::vector<std::uint64_t> begun;  ///< what those left before the last state() or restore()
    std::uint32_t launch = first_launch;
    double seconds = 0;

    State(const Device& on, const LayeredMedium& medium, const PhotonRequest& asked)
        : device(on),
          request(asked),
          layers(medium.layers.size()),
          kernel(on, photon_program(medium, asked), asked.seed),
          sums(kernel.program().sums),
          next(asked.first),
          begun(kernel.program().sums)
    {
    }

    void run(std::uint32_t count)
    {
        const double took = kernel.run(next, count);
        seconds += took;
        const double fitting = count * launch_seconds / std::max(took, 1e-6);
        launch = static_cast<std::uint32_t>(
            std::clamp(fitting, launch / 2.0, std::min<double>(launch * 2.0, largest_launch)));
        next += count;
        in_batch += count;
    }

    /// Moves what the device has counted to `begun`.
    void collect()
    {
        const std::vector<std::uint64_t> more = kernel.take_sums();
        std::ranges::transform(begun, more, begun.begin(), std::plus());
    }

    void end_batch()
    {
        collect();
        std::vector<std::uint64_t> weights(begun.size());
        std::swap(weights, begun);
        if (request.light.beam != Beam::diffuse)
            weights[total_specular] += in_batch * (whole_photon - kernel.program().source.weight);
        require_balance(weights, layers, in_batch, device.info());
        sums.add_batch(weights, in_batch);
        in_batch = 0;
    }
};

PhotonTracer::PhotonTracer(const Device& device, const LayeredMedium& medium,
                           const PhotonRequest& request)
    : state_(std::make_unique<State>(device, medium, request))
{
}

PhotonTracer::~PhotonTracer() = default;

void PhotonTracer::trace(std::uint64_t photons,
                         const std::function<void(std::uint64_t)>& after_launch)
{
    State& s = *state_;
    while (photons > 0) {
        const auto count = static_cast<std::uint32_t>(
            std::min({photons, s.request.batch - s.in_batch, std::uint64_t{s.launch}}));
        s.run(count);
        photons -= count;
        if (s.in_batch == s.request.batch || photons == 0) s.end_batch();
        after_launch(count);
    }
}

PhotonResult PhotonTracer::result() const
{
    const WeightSums& sums = state_->sums;
    const PhotonProgram& program = state_->kernel.program();
    const PhotonTallies& tallies = state_->request.tallies;
    const auto bins = [&](bool asked, std::size_t first, std::size_t count) {
        return sums.fractions(first, asked ? count : 0);
    };
    const std::size_t wavelengths = tallies.spectrum.size();
    const std::size_t all_light = program.spectrum + (tallies.rows + 1) * wavelengths;
    std::vector<double> squares;
    for (std::size_t k = 0; k < wavelengths; ++k)
        squares.push_back(sums.fraction(all_light + wavelengths + k).mean);
    return {.photons = sums.photons(),
            .specular = sums.fraction(total_specular),
            .diffuse_reflectance = sums.fraction(total_reflected),
            .unscattered_transmittance = sums.fraction(total_unscattered),
            .diffuse_transmittance = sums.fraction(total_transmitted),
            .bottom_absorption = sums.fraction(total_bottom),
            .unfinished = sums.fraction(total_unfinished),
            .took = sums.fraction(total_took),
            .gave = sums.fraction(total_gave),
            .absorption = sums.fractions(photon_totals, state_->layers),
            .reflected = bins(tallies.reflected, program.reflected, tallies.exit_bins()),
            .transmitted = bins(tallies.transmitted, program.transmitted, tallies.exit_bins()),
            .absorbed = bins(tallies.absorbed, program.absorbed, tallies.absorbed_bins()),
            .spectrum = sums.fractions(program.spectrum, all_light - program.spectrum),
            .spectrum_total = sums.fractions(all_light, wavelengths),
            .spectrum_squares = std::move(squares)};
}

std::string PhotonTracer::state() const
{
    State& s = *state_;
    s.collect();
    std::string bytes;
    nlohmann::json::to_cbor(nlohmann::json{{"next", s.next},
                                           {"in_batch", s.in_batch},
                                           {"seconds", s.seconds},
                                           {"begun", s.begun},
                                           {"sums", s.sums.state()}},
                            bytes);
    return bytes;
}

void PhotonTracer::restore(std::string_view state)
{
    State& s = *state_;
    try {
        const auto saved = nlohmann::json::from_cbor(state);
        auto begun = saved.at("begun").get<std::vector<std::uint64_t>>();
        if (begun.size() != s.begun.size()) throw UsageError("a state of other tallies");
        s.sums.restore(saved.at("sums"));
        s.begun = std::move(begun);
        s.next = saved.at("next");
        s.in_batch = saved.at("in_batch");
        s.seconds = saved.at("seconds");
    } catch (const nlohmann::json::exception&) {
        throw UsageError("not the state of a simulation");
    }
}

double PhotonTracer::kernel_seconds() const
{
    return state_->seconds;
}

}  // namespace gonio

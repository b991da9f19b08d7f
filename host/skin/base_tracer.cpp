// SPDX-License-Identifier: Apache-2.0
// The photons of one base, batch after batch.
#include "skin/base_tracer.hpp"

#include <algorithm>

#include "photon/bins.hpp"
#include "photon/checkpoint.hpp"

namespace gonio {
namespace {

PhotonRequest photon_request(const SpectralBase& base, std::size_t number,
                             const ProfileRequest& request)
{
    PhotonRequest photons{
        .seed = request.seed, .first = std::uint64_t{number} << 48, .batch = largest_batch};
    photons.tallies.rows = request.rings;
    photons.tallies.radius_width = request.width;
    photons.tallies.spectrum = base.more_absorption;
    return photons;
}

}  // namespace

BaseTracer::BaseTracer(const Device& device, const SpectralBase& base, std::size_t number,
                       const ProfileRequest& request, const nlohmann::ordered_json& from)
    : most_(request.photons),
      fixed_(request.max_error ? no_limit : request.photons),
      tracer_(device, base.medium, photon_request(base, number, request))
{
    if (from.is_null()) return;
    restore(tracer_, from.at("tracer"));
    photons_ = from.at("photons");
    batches_ = from.at("batches");
    ended_ = from.at("ended");
}

void BaseTracer::trace_batch(const std::function<void()>& after_launch)
{
    const std::uint64_t end = ended_ + std::min(batch_from(ended_, fixed_), most_ - ended_);
    tracer_.trace(end - photons_, [&](std::uint64_t count) {
        photons_ += count;
        after_launch();
    });
    ended_ = end;
    ++batches_;
}

nlohmann::ordered_json BaseTracer::state() const
{
    return {{"photons", photons_},
            {"batches", batches_},
            {"ended", ended_},
            {"tracer", state_of(tracer_)}};
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The photons of one base, batch after batch.
#include "skin/base_tracer.hpp"

#include <algorithm>
#include <cmath>

#include "photon/bins.hpp"
#include "photon/checkpoint.hpp"

namespace gonio {

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

BaseTracer::BaseTracer(const Device& device, const std::vector<SpectralBase>& bases,
                       std::size_t number, const ProfileRequest& request,
                       const nlohmann::ordered_json& from)
    : most_(request.photons),
      fixed_(request.max_error || request.ring_error || request.seconds ? no_limit
                                                                        : request.photons),
      seconds_(request.seconds.value_or(INFINITY) / static_cast<double>(bases.size())),
      tracer_(device, bases[number].medium, photon_request(bases[number], number, request))
{
    if (from.is_null()) return;
    restore(tracer_, from.at("tracer"));
    photons_ = from.at("photons");
    batches_ = from.at("batches");
    ended_ = from.at("ended");
    spent_ = from.at("spent");
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

double BaseTracer::part() const
{
    const double of_photons = static_cast<double>(photons_) / static_cast<double>(most_);
    return std::min(std::max(of_photons, spent() / seconds_), 1.0);
}

bool BaseTracer::has_ended() const
{
    const bool between_batches = photons_ == ended_;
    return ended_ == most_ || (between_batches && batches_ >= 2 && spent() >= seconds_);
}

nlohmann::ordered_json BaseTracer::state() const
{
    return {{"photons", photons_},
            {"batches", batches_},
            {"ended", ended_},
            {"spent", spent()},
            {"tracer", state_of(tracer_)}};
}

}  // namespace gonio

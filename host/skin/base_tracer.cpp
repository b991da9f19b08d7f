// SPDX-License-Identifier: Apache-2.0
// The photons of one base, batch after batch.
#include "skin/base_tracer.hpp"

#include <algorithm>

#include "photon/bins.hpp"

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
                       const ProfileRequest& request)
    : most_(request.photons),
      fixed_(request.max_error ? no_limit : request.photons),
      tracer_(device, base.medium, photon_request(base, number, request))
{
}

void BaseTracer::trace_batch(const std::function<void()>& after_launch)
{
    const std::uint64_t batch = std::min(batch_from(photons_, fixed_), most_ - photons_);
    tracer_.trace(batch, [&](std::uint64_t count) {
        photons_ += count;
        after_launch();
    });
    ++batches_;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The photons of one base, batch after batch.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/profile.hpp"
#include "skin/spectral_bases.hpp"
#include "stopwatch.hpp"

namespace gonio {

/// Of the photons of bases[number], which have numbers of their own.
PhotonRequest photon_request(const SpectralBase& base, std::size_t number,
                             const ProfileRequest& request);

class BaseTracer {
public:
    /// Of bases[number]. Bases have photons of their own, whose numbers begin with the base's, and
    /// share the time of the request. from: the state() of an earlier run, or null.
    BaseTracer(const Device& device, const std::vector<SpectralBase>& bases, std::size_t number,
               const ProfileRequest& request, const nlohmann::ordered_json& from);

    /// To the end of the batch at hand; what after_launch throws ends it before.
    void trace_batch(const std::function<void()>& after_launch);

    nlohmann::ordered_json state() const;
    /// That is done of its photons, or of its time if that ends before, up to 1.
    double part() const;
    /// Have its photons ended, or its time, where there are enough batches for an error?
    bool has_ended() const;

    PhotonResult result() const { return tracer_.result(); }
    std::uint64_t photons() const { return photons_; }
    std::uint64_t batches() const { return batches_; }
    double kernel_seconds() const { return tracer_.kernel_seconds(); }

private:
    double spent() const { return spent_ + since_.seconds(); }

    std::uint64_t most_;   ///< photons
    std::uint64_t fixed_;  ///< the same where no error and no time may end it before
    double seconds_;       ///< at most
    double spent_ = 0;     ///< by earlier runs
    Stopwatch since_;
    PhotonTracer tracer_;
    std::uint64_t photons_ = 0, batches_ = 0;
    std::uint64_t ended_ = 0;  ///< photons of those batches
};

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// The photons of one base, batch after batch.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "gonio/profile.hpp"
#include "skin/spectral_bases.hpp"

namespace gonio {

class BaseTracer {
public:
    /// Bases have photons of their own: their numbers begin with the base's. from: the state() of
    /// an earlier run, or null.
    BaseTracer(const Device& device, const SpectralBase& base, std::size_t number,
               const ProfileRequest& request, const nlohmann::ordered_json& from);

    /// To the end of the batch at hand; what after_launch throws ends it before.
    void trace_batch(const std::function<void()>& after_launch);

    nlohmann::ordered_json state() const;
    bool has_ended() const { return ended_ == most_; }

    PhotonResult result() const { return tracer_.result(); }
    std::uint64_t photons() const { return photons_; }
    std::uint64_t batches() const { return batches_; }
    double kernel_seconds() const { return tracer_.kernel_seconds(); }

private:
    std::uint64_t most_;   ///< photons
    std::uint64_t fixed_;  ///< the same where no error may end it before
    PhotonTracer tracer_;
    std::uint64_t photons_ = 0, batches_ = 0;
    std::uint64_t ended_ = 0;  ///< photons of those batches
};

}  // namespace gonio

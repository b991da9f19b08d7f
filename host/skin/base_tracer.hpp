// SPDX-License-Identifier: Apache-2.0
// The photons of one base, batch after batch.
#pragma once

#include <functional>

#include "gonio/profile.hpp"
#include "skin/spectral_bases.hpp"

namespace gonio {

class BaseTracer {
public:
    /// Bases have photons of their own: their numbers begin with the base's.
    BaseTracer(const Device& device, const SpectralBase& base, std::size_t number,
               const ProfileRequest& request);

    void trace_batch(const std::function<void()>& after_launch);

    PhotonResult result() const { return tracer_.result(); }
    std::uint64_t photons() const { return photons_; }
    std::uint64_t batches() const { return batches_; }
    double kernel_seconds() const { return tracer_.kernel_seconds(); }

private:
    std::uint64_t most_;   ///< photons
    std::uint64_t fixed_;  ///< the same where no error may end it before
    PhotonTracer tracer_;
    std::uint64_t photons_ = 0, batches_ = 0;
};

}  // namespace gonio

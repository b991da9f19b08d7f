// SPDX-License-Identifier: Apache-2.0
// How much there is to do for a picture, and how much of it is done.
#pragma once

#include <mutex>
#include <string_view>

#include "gonio/picture.hpp"

namespace gonio {

// What each part takes, in samples: 1.5 us of two cores (AVX-512), rays, shadows and shading.
constexpr double work_of_photon = 2, work_of_band = 4e4, work_of_spread_pixel = 1.5;

/// Counts what is done and tells it, to one caller at a time.
class PictureWork {
public:
    explicit PictureWork(const PictureProgress& after_each) : after_each_(after_each) {}

    /// What is being done from now on.
    void begin(std::string_view doing);

    /// As much of that is done, in samples. May be called by several threads.
    void advance(double amount);

private:
    const PictureProgress& after_each_;
    std::string_view doing_;
    std::mutex guard_;
};

}  // namespace gonio

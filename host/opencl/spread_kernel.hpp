// SPDX-License-Identifier: Apache-2.0
// Light below the surface in a picture, one Gaussian at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gonio/device.hpp"

namespace gonio {

/// Light that has entered, gathered in blocks of stride x stride pixels.
struct SpreadBlocks {
    unsigned stride = 1, columns = 0, rows = 0;
    std::vector<float> values;  ///< [row][column][block field]
};

class SpreadKernel {
public:
    /// places: [place plane][pixel], rows of `width`.
    SpreadKernel(const Device& device, std::size_t width, std::size_t height,
                 const std::vector<float>& places);
    ~SpreadKernel();
    SpreadKernel(const SpreadKernel&) = delete;
    SpreadKernel& operator=(const SpreadKernel&) = delete;

    /// [channel][pixel]: the light around each pixel, up to `radius` blocks from its own. variance:
    /// of the Gaussian, in the places' unit squared. Throws RunError.
    std::vector<float> spread(const SpreadBlocks& blocks, double variance, unsigned radius);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace gonio

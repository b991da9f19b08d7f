// SPDX-License-Identifier: Apache-2.0
// The photon kernel with its tallies on a device.
#pragma once

#include <cstdint>
#include <vector>

#include "opencl/state.hpp"
#include "photon/program.hpp"

namespace gonio {

/// How the work is divided: no matter for the result.
struct PhotonWork {
    std::size_t items = 0;        ///< work-items; 0 to choose by device
    bool shared_tallies = false;  ///< one set for all work-items
};

class PhotonKernel {
public:
    /// Throws UsageError where the tallies do not fit into the device's memory.
    PhotonKernel(const Device& device, PhotonProgram program, std::uint64_t seed,
                 PhotonWork work = {});

    /// Follows photons first to first + count - 1 and adds to the tallies; returns the seconds that
    /// it took by the device's clock.
    double run(std::uint64_t first, std::uint32_t count);

    /// The sums of all since the last time.
    std::vector<std::uint64_t> take_sums();

    const PhotonProgram& program() const { return program_; }

private:
    void clear();

    Device device_;
    PhotonProgram program_;
    PhotonWork work_;
    cl::Kernel kernel_;
    cl::Buffer tallies_, taken_, layers_, phases_;
};

}  // namespace gonio

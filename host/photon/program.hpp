// SPDX-License-Identifier: Apache-2.0
// What the photon kernel is compiled for, and the numbers that it reads.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gonio/photons.hpp"

namespace gonio {

/// Weight of a whole photon in the units of the kernel.
inline constexpr std::uint32_t whole_photon = std::uint32_t{1} << 30;

/// A beam behind the first boundary, and how diffuse light meets it.
struct KernelSource {
    float sine = 0, cosine = 1;
    std::uint32_t weight = whole_photon;  ///< what the boundary lets in
    float ratio = 1, excess = 0;
    float radius_x = 0, radius_y = 0;  ///< of the beam's ellipse on the surface, cm
};

struct PhotonProgram {
    std::string preamble;                  ///< the program's first lines
    std::vector<std::string> definitions;  ///< "NAME=VALUE"
    /// Records of layer_field; behind them the absorption of a spectrum, [layer][wavelength].
    std::vector<float> layers;
    std::vector<float> phases;  ///< records of segment_field, of all tables
    KernelSource source;
    float bottom_albedo = 0;
    float row_bins_per_unit = 0, radius_bins_per_cm = 0, depth_bins_per_cm = 0;
    std::size_t wavelengths = 0;  ///< of a spectrum
    // Places among the sums, behind the totals and the layers.
    std::size_t reflected = 0, transmitted = 0, absorbed = 0, spectrum = 0, sums = 0;
};

/// Throws UsageError as PhotonTracer does.
PhotonProgram photon_program(const LayeredMedium& medium, const PhotonRequest& request);

}  // namespace gonio

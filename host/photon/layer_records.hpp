// SPDX-License-Identifier: Apache-2.0
// Layers and light as the numbers that the photon kernel reads.
#pragma once

#include "photon/program.hpp"

namespace gonio {

/// Fills the program's records of layers and of their tabulated phase functions.
void add_layers(PhotonProgram& program, const LayeredMedium& medium);

/// Adds what each layer absorbs more at each wavelength, behind the records of the layers.
void add_spectrum(PhotonProgram& program, const PhotonTallies& tallies, std::size_t layers);

/// The light below the first boundary: Born and Wolf 1.5.2.
KernelSource refracted_beam(const LayeredMedium& medium, const LightSource& light);

}  // namespace gonio

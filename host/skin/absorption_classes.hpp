// SPDX-License-Identifier: Apache-2.0
// Which of a base's media are too dark for photons of its brightest one.
#pragma once

#include <vector>

#include "skin/spectral_bases.hpp"

namespace gonio {

/// Divides the shares of each base into classes that absorb so alike that the photons of one are
/// worth something to the others `reach` cm from the beam: a base for each class.
std::vector<SpectralBase> split_by_absorption(const std::vector<SpectralBase>& bases,
                                              const std::vector<LayeredMedium>& media,
                                              double reach);

}  // namespace gonio

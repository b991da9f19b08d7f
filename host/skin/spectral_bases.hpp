// SPDX-License-Identifier: Apache-2.0
// Which photons serve which wavelengths: absorption can be exchanged afterwards, scattering cannot.
#pragma once

#include <cstddef>
#include <vector>

#include "gonio/layers.hpp"
#include "gonio/profile.hpp"
#include "gonio/skin.hpp"

namespace gonio {

/// What a base adds to one of the media that are asked for.
struct BaseShare {
    std::size_t medium = 0;
    double weight = 1;
    double coarser = 1;  ///< the weight of a rule with one base less
};

/// Photons with the scattering of one wavelength, and in each layer the least absorption of all
/// that they serve.
struct SpectralBase {
    LayeredMedium medium;
    std::vector<BaseShare> shares;
    std::vector<std::vector<double>> more_absorption;  ///< 1/cm, [share][layer]
};

/// How near bases are.
struct BaseSpacing {
    double step = 0.4;  ///< of the logarithm of reduced scattering
    double reach = 0;   ///< cm, where relative errors count: bases are split_by_absorption()
};

/// As a request's errors need it.
BaseSpacing spacing_of(const ProfileRequest& request);

/// media: the same layers at several wavelengths, in their order. One base where scattering,
/// indices and thicknesses are the same at all. Else bases where reduced scattering has changed by
/// a step, and interpolation between the four that are nearest (Lagrange, in the logarithm of it);
/// as many as media if these are few.
std::vector<SpectralBase> spectral_bases(const std::vector<LayeredMedium>& media,
                                         const BaseSpacing& spacing = {});

/// 1/cm
double reduced_scattering(const Layer& layer);

/// Throws as Skin::layers_at() does. wavelengths: nm.
std::vector<LayeredMedium> media_of(const Skin& skin, const std::vector<double>& wavelengths);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Which of a base's media are too dark for photons of its brightest one.
#include "skin/absorption_classes.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {
namespace {

/// By how many times e diffusion weakens light from the beam to there (Ishimaru, Wave Propagation
/// and Scattering in Random Media, 1978, chapter 9), with coefficients that are means as deep.
double attenuation(const LayeredMedium& medium, double reach)
{
    double depth = 0, absorbed = 0, scattered = 0;
    for (const Layer& layer : medium.layers) {
        const double part = std::min(layer.d, reach - depth);
        depth += part;
        absorbed += layer.mua * part;
        scattered += reduced_scattering(layer) * part;
    }
    return std::sqrt(3 * absorbed * (absorbed + scattered));
}

}  // namespace

std::vector<SpectralBase> split_by_absorption(const std::vector<SpectralBase>& bases,
                                              const std::vector<LayeredMedium>& media, double reach)
{
    constexpr double widest = 6;  // of a class: a factor of 400 at the end
    std::vector<double> attenuations;
    for (const LayeredMedium& medium : media) attenuations.push_back(attenuation(medium, reach));
    const auto by_attenuation = [&](const BaseShare& share) { return attenuations[share.medium]; };
    std::vector<SpectralBase> all;
    for (const SpectralBase& base : bases) {
        std::vector<BaseShare> shares = base.shares;
        std::ranges::stable_sort(shares, {}, by_attenuation);
        double first = -INFINITY;
        for (const BaseShare& share : shares) {
            if (by_attenuation(share) > first + widest) {
                all.push_back({base.medium, {}, {}});
                first = by_attenuation(share);
            }
            all.back().shares.push_back(share);
        }
    }
    return all;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Light of all bases by wavelength and ring.
#include "skin/collected_rings.hpp"

#include <algorithm>
#include <cmath>

namespace gonio {

void SharedFraction::add(const Fraction& part, const BaseShare& share)
{
    const double off = share.weight - share.coarser;
    mean_ += share.weight * part.mean;
    variance_ += std::pow(share.weight * part.error, 2);
    coarser_ += off * part.mean;
    noise_ += std::pow(off * part.error, 2);
}

Fraction SharedFraction::fraction() const
{
    const double bias = std::max(coarser_ * coarser_ - noise_, 0.0);
    return {mean_, std::sqrt(variance_ + bias)};
}

CollectedRings::CollectedRings(std::size_t wavelengths, std::size_t rings)
    : rings_(wavelengths, std::vector<SharedFraction>(rings)),
      total_(wavelengths),
      squares_(wavelengths)
{
}

void CollectedRings::add(const SpectralBase& base, const PhotonResult& found)
{
    const std::size_t stride = base.shares.size();
    for (std::size_t k = 0; k < stride; ++k) {
        const BaseShare& share = base.shares[k];
        auto& rings = rings_[share.medium];
        for (std::size_t ring = 0; ring < rings.size(); ++ring)
            rings[ring].add(found.spectrum[ring * stride + k], share);
        total_[share.medium].add(found.spectrum_total[k], share);
        squares_[share.medium] += share.weight * share.weight * found.spectrum_squares[k] /
                                  static_cast<double>(found.photons);
    }
}

void CollectedRings::write(RadialSpectrum& spectrum) const
{
    for (std::size_t k = 0; k < total_.size(); ++k) {
        auto& rings = spectrum.rings.emplace_back();
        for (const SharedFraction& ring : rings_[k]) rings.push_back(ring.fraction());
        spectrum.total.push_back(total_[k].fraction());
        const double mean = spectrum.total.back().mean;
        spectrum.effective_photons.push_back(squares_[k] > 0 ? mean * mean / squares_[k] : 0);
    }
}

}  // namespace gonio

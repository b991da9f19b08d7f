// SPDX-License-Identifier: Apache-2.0
// Light of all bases by wavelength and ring: their parts by their shares.
#pragma once

#include <cstddef>
#include <vector>

#include "gonio/profile.hpp"
#include "skin/spectral_bases.hpp"

namespace gonio {

/// Sums over bases. A wavelength's bases have photons of their own, so that their noise is
/// independent.
class SharedFraction {
public:
    void add(const Fraction& part, const BaseShare& share);

    /// The rule with one base less is off by more than this one; without its own noise.
    Fraction fraction() const;

private:
    double mean_ = 0, variance_ = 0, coarser_ = 0, noise_ = 0;
};

/// All that the bases have found, by wavelength.
class CollectedRings {
public:
    CollectedRings(std::size_t wavelengths, std::size_t rings);

    void add(const SpectralBase& base, const PhotonResult& found);
    void write(RadialSpectrum& spectrum) const;

private:
    std::vector<std::vector<SharedFraction>> rings_;
    std::vector<SharedFraction> total_;
    std::vector<double> squares_;
};

}  // namespace gonio

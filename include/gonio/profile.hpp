// SPDX-License-Identifier: Apache-2.0
// How light spreads below the surface of skin: R(r) by photons, as a spectrum and as renderers load
// it, the functions that are fitted to it, and the light that bleeds around a curved surface.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/photons.hpp"
#include "gonio/skin.hpp"

namespace gonio {

/// The light of a thin white beam along the normal that skin returns, without what its
/// surface reflects, in linear sRGB for the CIE 1931 observer. Red light that spreads farthest is
/// outside what sRGB can show: green and blue are a little below 0 there.
struct RadialProfile {
    double width = 0;                                 ///< of a ring, cm
    std::array<std::vector<Fraction>, 3> rings = {};  ///< [R, G, B][ring]
    std::array<Fraction, 3> total = {};               ///< with what leaves beyond the last ring
    std::uint64_t photons = 0;                        ///< that a band sees, at least
};

struct ProfileRequest {
    double width = 0.002;  ///< of a ring, cm
    std::size_t rings = 500;
    std::uint64_t photons = 100'000;     ///< that a wavelength sees, at most; up to 2^48
    std::optional<double> seconds = {};  ///< that it all takes, about, at most
    /// Of R(r) at each wavelength, the largest standard error over the largest value: fewer photons
    /// may do. Of spectra only.
    std::optional<double> max_error = {};
    /// The root of the mean over the rings of their squared relative errors, at each wavelength:
    /// dark wavelengths get photons of their own. Of spectra only.
    std::optional<double> ring_error = {};
    std::uint64_t seed = 1;
};

/// The light of a thin beam along the normal that skin returns at each wavelength, without what its
/// surface reflects. Wavelengths share photons, and so their noise.
struct RadialSpectrum {
    double width = 0;                               ///< of a ring, cm
    std::vector<std::vector<Fraction>> rings = {};  ///< [wavelength][ring]
    std::vector<Fraction> total = {};               ///< with what leaves beyond the last ring
    std::vector<double> effective_photons = {};     ///< (sum of weights)^2 / sum of squared ones
    std::vector<std::uint64_t> photons = {};        ///< of each base
    double kernel_seconds = 0;
};

/// Absorption is exchanged along each path, exactly. Where scattering changes with the wavelength,
/// photons of several bases are interpolated between; what that is off, by a rule with one base
/// less, is in the errors. `after_each` as in trace_profile(). wavelengths: nm, monotonic. Throws
/// as Skin::layers_at() and PhotonTracer do.
RadialSpectrum trace_spectrum(
    const Device& device, const Skin& skin, const std::vector<double>& wavelengths,
    const ProfileRequest& request,
    const std::function<void(double part_done)>& after_each = [](double) {});

/// Layers as a part of the spectrum sees them, and the linear sRGB of its light.
struct ColourBand {
    LayeredMedium layers;
    glm::dvec3 colour{1};
};

/// Skin at every 20 nm from 380 to 780: what reflectance 1 at one of these wavelengths, 0 at its
/// neighbours, is to the CIE 1931 observer in D65. Throws as Skin::layers_at().
std::vector<ColourBand> bands_of(const Skin& skin);

/// Follows photons for all bands, which share them as wavelengths of trace_spectrum() do.
/// `after_each` is called after each launch; what it throws ends the work. Throws as PhotonTracer
/// does.
RadialProfile trace_profile(
    const Device& device, const std::vector<ColourBand>& bands, const ProfileRequest& request,
    const std::function<void(double part_done)>& after_each = [](double) {});

/// R(r) = sum of w exp(-r^2/(2 v))/(2 pi v), per mm^2 (d'Eon & Luebke, GPU Gems 3, chapter 14,
/// 2007).
struct SumOfGaussians {
    std::vector<double> variances;               ///< v, mm^2
    std::vector<std::array<double, 3>> weights;  ///< w of R, G, B, none negative
};

/// R(r) = A/(8 pi d r) (exp(-r/d) + exp(-r/(3 d))) (Burley, SIGGRAPH course notes, 2015).
struct BurleyProfile {
    std::array<double, 3> albedo, distance;  ///< A, and d in mm
};

/// A function, and how far it is from the photons: the root of the mean of r (difference)^2 over
/// that of r R(r)^2, d'Eon & Luebke's measure.
template <typename Function>
struct ProfileFit {
    Function function;
    std::array<double, 3> error;
};

/// Six Gaussians, the same six for all channels, whose weights add up to the light that returns.
ProfileFit<SumOfGaussians> fit_gaussians(const RadialProfile& profile);

/// A is the light that returns, d is fitted. Throws RunError where a channel returns none.
ProfileFit<BurleyProfile> fit_burley(const RadialProfile& profile);

/// Irradiance that spreads over a sphere in a directional light, by that of a plane that faces it:
/// the integral of max(0, n.l) R(chord) over the sphere, by that of R. (Penner & Borshukov, GPU
/// Pro 2, 2011, integrate along a ring in its place.) curvature: 1/mm, 0 for a plane. Where a
/// channel has no light its value is 0.
std::array<double, 3> around_a_sphere(const SumOfGaussians& profile, double n_dot_l,
                                      double curvature);

}  // namespace gonio

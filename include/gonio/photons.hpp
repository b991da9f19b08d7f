// SPDX-License-Identifier: Apache-2.0
// Light in layers by Monte Carlo on a device: where it ends, with standard errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/device.hpp"
#include "gonio/layers.hpp"

namespace gonio {

/// By what light that leaves is told apart besides its angle: the distance from the axis; the
/// azimuth, 0 to 180 degrees on either side of where the beam goes, without unscattered light; or
/// the time since it entered the first layer.
enum class ExitRow { radius, azimuth, time };

/// Bins of what is tallied, even and from 0 on. A tally that is not asked for is not computed.
/// Radii, times and depths beyond the bins have one more bin for themselves, angles reach to 90
/// degrees.
struct PhotonTallies {
    bool reflected = false;    ///< [row][angle]
    bool transmitted = false;  ///< [row][angle], what was never scattered included
    bool absorbed = false;     ///< [depth][absorbed radius]
    ExitRow row = ExitRow::radius;
    double radius_width = 0.01, depth_width = 0.01;  ///< cm
    double time_width = 1;                           ///< ps
    std::size_t rows = 0, angles = 1;                ///< of reflected and transmitted; angles >= 1
    std::size_t depths = 0, absorbed_radii = 0;
    /// Reflected light by distance at several wavelengths besides, all of the same paths: by how
    /// much layers absorb more than those of the medium, 1/cm, [wavelength][layer].
    std::vector<std::vector<double>> spectrum = {};

    std::size_t exit_bins() const { return (rows + 1) * angles; }
    std::size_t absorbed_bins() const { return (depths + 1) * (absorbed_radii + 1); }
};

/// What to simulate. The result depends on nothing else: not on the device's vector width, nor on
/// how the work is divided.
struct PhotonRequest {
    LightSource light = {};
    PhotonTallies tallies = {};
    std::uint64_t seed = 1;
    std::uint64_t first = 0;  ///< number of the first photon
    /// Photons whose sums are squared for the errors; at least 2, at most 2^30.
    std::uint64_t batch = std::uint64_t{1} << 14;
    /// Weight below which a photon lives on with a probability of 1/8 only: MCML's 1e-4 sees
    /// farther into the depth and takes longer. In (0, 1/8].
    double roulette_below = 0x1p-7;
};

/// A fraction of the incident light.
struct Fraction {
    double mean = 0;
    double error = 0;  ///< standard error; infinite where there is one batch only
};

/// What a simulation has found so far.
struct PhotonResult {
    std::uint64_t photons = 0;
    // The means add up to 1 + gave - took.
    Fraction specular;             ///< met nothing that absorbs or scatters (MCML's Rsp)
    Fraction diffuse_reflectance;  ///< all else that leaves upwards (MCML's Rd)
    Fraction unscattered_transmittance, diffuse_transmittance;
    Fraction bottom_absorption, unfinished;                  ///< unfinished: ended after 2^22 steps
    Fraction took, gave;                                     ///< by roulette
    std::vector<Fraction> absorption;                        ///< in each layer
    std::vector<Fraction> reflected, transmitted, absorbed;  ///< bins as PhotonTallies says
    std::vector<Fraction> spectrum;                          ///< [row][wavelength]
    std::vector<Fraction> spectrum_total;  ///< [wavelength]; all that leaves upwards
    std::vector<double> spectrum_squares;  ///< [wavelength]; the mean of a photon's squared score
};

/// The simulation of one request, which goes on as long as it is asked to.
class PhotonTracer {
public:
    /// Throws UsageError as validate() does, for an incidence or a radius out of range, a spectrum
    /// that absorbs less than the medium or has rows that are no radii, and where the tallies do
    /// not fit into the device's memory.
    PhotonTracer(const Device& device, const LayeredMedium& medium, const PhotonRequest& request);
    ~PhotonTracer();
    PhotonTracer(const PhotonTracer&) = delete;
    PhotonTracer& operator=(const PhotonTracer&) = delete;

    /// Follows that many more photons, in launches of about 150 ms; after_launch gets the number
    /// of photons of each and may throw. Throws CheckFailed where weight was lost.
    void trace(
        std::uint64_t photons,
        const std::function<void(std::uint64_t)>& after_launch = [](std::uint64_t) {});

    /// Of all photons so far.
    PhotonResult result() const;

    /// Everything that it would take to go on later.
    std::string state() const;
    /// Goes on from a state of a tracer of the same medium and request, on any device. Throws
    /// UsageError where it is not one.
    void restore(std::string_view state);

    double kernel_seconds() const;  ///< by the device's clock

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// R(r) of skin: photons in each band, added up by their colours.
#include "gonio/profile.hpp"

#include <cmath>

#include "gonio/colour.hpp"
#include "photon/bins.hpp"

namespace gonio {
namespace {

/// As far apart as a colour allows: spectra of skin are smooth.
std::vector<double> sampled_wavelengths()
{
    std::vector<double> all;
    for (int wavelength = 380; wavelength <= 780; wavelength += 20) all.push_back(wavelength);
    return all;
}

/// The errors are variances until the end.
void add(Fraction& sum, const Fraction& part, double weight)
{
    sum.mean += weight * part.mean;
    sum.error += std::pow(weight * part.error, 2);
}

}  // namespace

std::vector<ColourBand> bands_of(const Skin& skin)
{
    const auto wavelengths = sampled_wavelengths();
    std::vector<ColourBand> bands;
    for (std::size_t k = 0; k < wavelengths.size(); ++k) {
        std::vector<double> peak(wavelengths.size());
        peak[k] = 1;
        bands.push_back(
            {skin.layers_at(wavelengths[k]), linear_srgb(tristimulus(wavelengths, peak))});
    }
    return bands;
}

RadialProfile trace_profile(const Device& device, const std::vector<ColourBand>& bands,
                            const ProfileRequest& request,
                            const std::function<void(double part_done)>& after_each)
{
    RadialProfile profile{.width = request.width};
    for (auto& channel : profile.rings) channel.resize(request.rings);
    PhotonRequest photons{.seed = request.seed, .batch = batch_of(request.photons)};
    photons.tallies.reflected = true;
    photons.tallies.rows = request.rings;
    photons.tallies.radius_width = request.width;
    double done = 0;
    const double all = static_cast<double>(request.photons * bands.size());
    for (std::size_t k = 0; k < bands.size(); ++k) {
        // Bands have photons of their own, so that their noise is independent.
        photons.first = std::uint64_t{k} << 48;
        PhotonTracer tracer(device, bands[k].layers, photons);
        tracer.trace(request.photons, [&](std::uint64_t count) {
            done += static_cast<double>(count);
            after_each(done / all);
        });
        const PhotonResult found = tracer.result();
        for (int c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            add(profile.total[channel], found.diffuse_reflectance, bands[k].colour[c]);
            for (std::size_t ring = 0; ring < request.rings; ++ring)
                add(profile.rings[channel][ring], found.reflected[ring], bands[k].colour[c]);
        }
    }
    for (auto& total : profile.total) total.error = std::sqrt(total.error);
    for (auto& channel : profile.rings)
        for (Fraction& ring : channel) ring.error = std::sqrt(ring.error);
    return profile;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// R(r) of skin: photons at each wavelength, added up by the observer's linear weights.
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

/// What reflectance 1 at one of the wavelengths, 0 at its neighbours, adds to R, G and B.
glm::dvec3 weight_of(const std::vector<double>& wavelengths, std::size_t which)
{
    std::vector<double> peak(wavelengths.size());
    peak[which] = 1;
    return linear_srgb(tristimulus(wavelengths, peak));
}

/// The errors are variances until the end.
void add(Fraction& sum, const Fraction& part, double weight)
{
    sum.mean += weight * part.mean;
    sum.error += std::pow(weight * part.error, 2);
}

}  // namespace

RadialProfile trace_profile(const Device& device, const Skin& skin, const ProfileRequest& request,
                            const std::function<void(double part_done)>& after_each)
{
    const auto wavelengths = sampled_wavelengths();
    RadialProfile profile{.width = request.width};
    for (auto& channel : profile.rings) channel.resize(request.rings);
    PhotonRequest photons{.seed = request.seed, .batch = batch_of(request.photons)};
    photons.tallies.reflected = true;
    photons.tallies.rows = request.rings;
    photons.tallies.radius_width = request.width;
    double done = 0;
    const double all = static_cast<double>(request.photons * wavelengths.size());
    for (std::size_t k = 0; k < wavelengths.size(); ++k) {
        // Wavelengths have photons of their own, so that their noise is independent.
        photons.first = std::uint64_t{k} << 48;
        PhotonTracer tracer(device, skin.layers_at(wavelengths[k]), photons);
        tracer.trace(request.photons, [&](std::uint64_t count) {
            done += static_cast<double>(count);
            after_each(done / all);
        });
        const PhotonResult found = tracer.result();
        const glm::dvec3 weight = weight_of(wavelengths, k);
        for (int c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            add(profile.total[channel], found.diffuse_reflectance, weight[c]);
            for (std::size_t ring = 0; ring < request.rings; ++ring)
                add(profile.rings[channel][ring], found.reflected[ring], weight[c]);
        }
    }
    for (auto& total : profile.total) total.error = std::sqrt(total.error);
    for (auto& channel : profile.rings)
        for (Fraction& ring : channel) ring.error = std::sqrt(ring.error);
    return profile;
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// R(r) in linear sRGB: bands, which share photons, added up by their colours.
#include "gonio/profile.hpp"

#include <algorithm>
#include <cmath>

#include "gonio/colour.hpp"
#include "skin/base_tracer.hpp"

namespace gonio {
namespace {

/// As far apart as a colour allows: spectra of skin are smooth.
std::vector<double> sampled_wavelengths()
{
    std::vector<double> all;
    for (int wavelength = 380; wavelength <= 780; wavelength += 20) all.push_back(wavelength);
    return all;
}

/// A number in R, G and B of which all photons so far are known: sums over batches, whose spread is
/// that of the colour, since bands share their noise.
class Colour {
public:
    /// so_far: per photon; `photons` of all, `more` in the last batch.
    void update(const glm::dvec3& so_far, double photons, double more)
    {
        const glm::dvec3 sum = so_far * photons, batch = sum - sum_;
        sum_ = sum;
        squares_ += batch * batch / more;
    }

    /// Adds mean and, as their error, variance to those of other photons.
    void add_to(std::array<Fraction*, 3> to, double photons, double batches) const
    {
        for (int c = 0; c < 3; ++c) {
            const double spread = std::max(squares_[c] - sum_[c] * sum_[c] / photons, 0.0);
            Fraction& one = *to[static_cast<std::size_t>(c)];
            one.mean += sum_[c] / photons;
            one.error += batches > 1 ? spread / (batches - 1) / photons : INFINITY;
        }
    }

private:
    glm::dvec3 sum_{0}, squares_{0};
};

/// The rings and the total of one base.
class ColouredRings {
public:
    /// part_of: what a share counts, of its band.
    ColouredRings(const SpectralBase& base, const std::vector<ColourBand>& bands, std::size_t rings,
                  double (*part_of)(const BaseShare&))
        : rings_(rings)
    {
        for (const BaseShare& share : base.shares)
            weights_.push_back(part_of(share) * bands[share.medium].colour);
    }

    void update(const PhotonResult& found)
    {
        const auto photons = static_cast<double>(found.photons), more = photons - photons_;
        const std::size_t stride = weights_.size();
        for (std::size_t ring = 0; ring < rings_.size(); ++ring)
            rings_[ring].update(sum(&found.spectrum[ring * stride]), photons, more);
        total_.update(sum(found.spectrum_total.data()), photons, more);
        photons_ = photons;
        ++batches_;
    }

    void add_to(RadialProfile& profile) const
    {
        auto& [red, green, blue] = profile.rings;
        for (std::size_t ring = 0; ring < rings_.size(); ++ring)
            rings_[ring].add_to({&red[ring], &green[ring], &blue[ring]}, photons_, batches_);
        auto& total = profile.total;
        total_.add_to({&total[0], &total[1], &total[2]}, photons_, batches_);
    }

private:
    glm::dvec3 sum(const Fraction* light) const
    {
        glm::dvec3 all(0);
        for (std::size_t k = 0; k < weights_.size(); ++k) all += weights_[k] * light[k].mean;
        return all;
    }

    std::vector<glm::dvec3> weights_;  ///< of the base's bands
    std::vector<Colour> rings_;
    Colour total_;
    double photons_ = 0, batches_ = 0;
};

RadialProfile empty_profile(const ProfileRequest& request)
{
    RadialProfile profile{.width = request.width};
    for (auto& channel : profile.rings) channel.resize(request.rings);
    return profile;
}

/// From a variance to an error, with what a rule with one base less is off, without its own noise.
void finish(Fraction& one, const Fraction& off)
{
    one.error = std::sqrt(one.error + std::max(off.mean * off.mean - off.error, 0.0));
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
    std::vector<LayeredMedium> media;
    for (const ColourBand& band : bands) media.push_back(band.layers);
    const auto bases = spectral_bases(media);
    RadialProfile profile = empty_profile(request), off = profile;
    const double all = static_cast<double>(request.photons) * static_cast<double>(bases.size());
    double done = 0;
    for (std::size_t k = 0; k < bases.size(); ++k) {
        BaseTracer tracer(device, bases[k], k, request);
        ColouredRings rings(bases[k], bands, request.rings,
                            [](const BaseShare& share) { return share.weight; });
        ColouredRings offs(bases[k], bands, request.rings,
                           [](const BaseShare& share) { return share.weight - share.coarser; });
        while (tracer.photons() < request.photons) {
            tracer.trace_batch(
                [&] { after_each((done + static_cast<double>(tracer.photons())) / all); });
            const PhotonResult found = tracer.result();
            rings.update(found);
            offs.update(found);
        }
        done += static_cast<double>(tracer.photons());
        rings.add_to(profile);
        offs.add_to(off);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        finish(profile.total[c], off.total[c]);
        for (std::size_t ring = 0; ring < request.rings; ++ring)
            finish(profile.rings[c][ring], off.rings[c][ring]);
    }
    return profile;
}

}  // namespace gonio

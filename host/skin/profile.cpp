// SPDX-License-Identifier: Apache-2.0
// R(r) in linear sRGB: bands, which share photons, added up by their colours.
#include "gonio/profile.hpp"

#include <algorithm>
#include <cmath>

#include "gonio/colour.hpp"
#include "skin/base_tracer.hpp"
#include "skin/resumable.hpp"

namespace gonio {
namespace {

/// As far apart as a colour allows: spectra of skin are smooth.
std::vector<double> sampled_wavelengths()
{
    std::vector<double> all;
    for (int wavelength = 380; wavelength <= 780; wavelength += 20) all.push_back(wavelength);
    return all;
}

/// The rings of one base in R, G and B, and behind them the total: sums over batches, whose spread
/// is that of the colour, since bands share their noise.
class ColouredRings {
public:
    /// part_of: what a share counts, of its band. from: an earlier state(), or null.
    ColouredRings(const SpectralBase& base, const std::vector<ColourBand>& bands, std::size_t rings,
                  double (*part_of)(const BaseShare&), const nlohmann::ordered_json& from)
        : sums_(rings + 1), squares_(rings + 1)
    {
        for (const BaseShare& share : base.shares)
            weights_.push_back(part_of(share) * bands[share.medium].colour);
        if (from.is_null()) return;
        sums_ = from.at("sums");
        squares_ = from.at("squares");
        photons_ = from.at("photons");
        batches_ = from.at("batches");
    }

    nlohmann::ordered_json state() const
    {
        return {
            {"sums", sums_}, {"squares", squares_}, {"photons", photons_}, {"batches", batches_}};
    }

    /// Of all photons so far, a batch more than before.
    void update(const PhotonResult& found)
    {
        const auto photons = static_cast<double>(found.photons);
        const std::size_t rings = sums_.size() - 1, stride = weights_.size();
        for (std::size_t ring = 0; ring < rings; ++ring)
            update(ring, &found.spectrum[ring * stride], photons);
        update(rings, found.spectrum_total.data(), photons);
        photons_ = photons;
        ++batches_;
    }

    /// Adds means and, as their errors, variances to those of other photons.
    void add_to(RadialProfile& profile) const
    {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t ring = 0; ring < profile.rings[c].size(); ++ring)
                add_to(profile.rings[c][ring], ring, c);
            add_to(profile.total[c], sums_.size() - 1, c);
        }
    }

private:
    using Colour = std::array<double, 3>;

    void update(std::size_t place, const Fraction* light, double photons)
    {
        glm::dvec3 colour(0);
        for (std::size_t k = 0; k < weights_.size(); ++k) colour += weights_[k] * light[k].mean;
        for (std::size_t c = 0; c < 3; ++c) {
            const double sum = colour[static_cast<int>(c)] * photons;
            squares_[place][c] += std::pow(sum - sums_[place][c], 2) / (photons - photons_);
            sums_[place][c] = sum;
        }
    }

    void add_to(Fraction& one, std::size_t place, std::size_t c) const
    {
        const double sum = sums_[place][c];
        const double spread = std::max(squares_[place][c] - sum * sum / photons_, 0.0);
        one.mean += sum / photons_;
        one.error += batches_ > 1 ? spread / (batches_ - 1) / photons_ : INFINITY;
    }

    std::vector<glm::dvec3> weights_;  ///< of the base's bands
    std::vector<Colour> sums_, squares_;
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
                            const ProfileRequest& request, const nlohmann::ordered_json& from,
                            const AfterLaunch& after_launch)
{
    std::vector<LayeredMedium> media;
    for (const ColourBand& band : bands) media.push_back(band.layers);
    const auto bases = spectral_bases(media);
    RadialProfile profile = empty_profile(request), off = profile;
    profile.photons = UINT64_MAX;
    const auto all = static_cast<double>(bases.size());
    nlohmann::ordered_json states = from;
    for (std::size_t k = 0; k < bases.size(); ++k) {
        nlohmann::ordered_json& state = states[k];
        BaseTracer tracer(device, bases, k, request, state["tracer"]);
        ColouredRings rings(
            bases[k], bands, request.rings, [](const BaseShare& share) { return share.weight; },
            state["rings"]);
        ColouredRings offs(
            bases[k], bands, request.rings,
            [](const BaseShare& share) { return share.weight - share.coarser; }, state["offs"]);
        const auto updated = [&] {
            state = {{"tracer", tracer.state()}, {"rings", rings.state()}, {"offs", offs.state()}};
            return states;
        };
        while (!tracer.has_ended()) {
            tracer.trace_batch(
                [&] { after_launch((static_cast<double>(k) + tracer.part()) / all, updated); });
            const PhotonResult found = tracer.result();
            rings.update(found);
            offs.update(found);
        }
        updated();
        profile.photons = std::min(profile.photons, tracer.photons());
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

RadialProfile trace_profile(const Device& device, const std::vector<ColourBand>& bands,
                            const ProfileRequest& request,
                            const std::function<void(double part_done)>& after_each)
{
    return trace_profile(device, bands, request, nullptr,
                         [&](double part, const auto&) { after_each(part); });
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// R(r) of skin at many wavelengths: photons of each base, added up by their shares.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/profile.hpp"
#include "photon/bins.hpp"
#include "skin/base_tracer.hpp"
#include "skin/resumable.hpp"

namespace gonio {
namespace {

/// Sums over bases. A wavelength's bases have photons of their own, so that their noise is
/// independent.
class Combined {
public:
    void add(const Fraction& part, const BaseShare& share)
    {
        const double off = share.weight - share.coarser;
        mean_ += share.weight * part.mean;
        variance_ += std::pow(share.weight * part.error, 2);
        coarser_ += off * part.mean;
        noise_ += std::pow(off * part.error, 2);
    }

    /// The rule with one base less is off by more than this one; without its own noise.
    Fraction fraction() const
    {
        const double bias = std::max(coarser_ * coarser_ - noise_, 0.0);
        return {mean_, std::sqrt(variance_ + bias)};
    }

private:
    double mean_ = 0, variance_ = 0, coarser_ = 0, noise_ = 0;
};

/// All that the bases have found, by wavelength.
class Collected {
public:
    Collected(std::size_t wavelengths, std::size_t rings)
        : rings_(wavelengths, std::vector<Combined>(rings)),
          total_(wavelengths),
          squares_(wavelengths)
    {
    }

    void add(const SpectralBase& base, const PhotonResult& found)
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

    void write(RadialSpectrum& spectrum) const
    {
        for (std::size_t k = 0; k < total_.size(); ++k) {
            auto& rings = spectrum.rings.emplace_back();
            for (const Combined& ring : rings_[k]) rings.push_back(ring.fraction());
            spectrum.total.push_back(total_[k].fraction());
            const double mean = spectrum.total.back().mean;
            spectrum.effective_photons.push_back(squares_[k] > 0 ? mean * mean / squares_[k] : 0);
        }
    }

private:
    std::vector<std::vector<Combined>> rings_;
    std::vector<Combined> total_;
    std::vector<double> squares_;
};

/// Errors over those that are asked for; of all wavelengths the largest.
double times_wanted(const PhotonResult& found, std::size_t wavelengths,
                    const ProfileRequest& request)
{
    double largest = 0;
    for (std::size_t k = 0; k < wavelengths; ++k) {
        std::vector<Fraction> densities;
        for (std::size_t ring = 0; ring < request.rings; ++ring) {
            const double area = ring_area(ring, request.width);
            const Fraction& light = found.spectrum[ring * wavelengths + k];
            densities.push_back({light.mean / area, light.error / area});
        }
        if (request.max_error)
            largest = std::max(largest, largest_error(densities) / *request.max_error);
        if (request.ring_error)
            largest = std::max(largest, mean_relative_error(densities) / *request.ring_error);
    }
    return largest;
}

}  // namespace

RadialSpectrum trace_spectrum(const Device& device, const Skin& skin,
                              const std::vector<double>& wavelengths, const ProfileRequest& request,
                              const nlohmann::ordered_json& from, const AfterLaunch& after_launch)
{
    const auto bases = spectral_bases(media_of(skin, wavelengths), reach_of(request));
    const bool to_error = request.max_error || request.ring_error;
    Collected all(wavelengths.size(), request.rings);
    RadialSpectrum spectrum{.width = request.width};
    const auto each = static_cast<double>(bases.size());
    nlohmann::ordered_json states = from;
    for (std::size_t k = 0; k < bases.size(); ++k) {
        BaseTracer tracer(device, bases, k, request, states[k]);
        const auto measured = [&] {
            return to_error && tracer.batches() >= least_batches
                       ? times_wanted(tracer.result(), bases[k].shares.size(), request)
                       : std::numeric_limits<double>::infinity();
        };
        double error = measured();
        const auto part = [&] { return std::max(tracer.part(), std::pow(error, -2)); };
        const auto state = [&] {
            states[k] = tracer.state();
            return states;
        };
        while (!tracer.has_ended() && error > 1) {
            tracer.trace_batch([&] {
                after_launch((static_cast<double>(k) + std::min(part(), 1.0)) / each, state);
            });
            error = measured();
        }
        state();
        all.add(bases[k], tracer.result());
        spectrum.photons.push_back(tracer.photons());
        spectrum.kernel_seconds += tracer.kernel_seconds();
    }
    all.write(spectrum);
    return spectrum;
}

RadialSpectrum trace_spectrum(const Device& device, const Skin& skin,
                              const std::vector<double>& wavelengths, const ProfileRequest& request,
                              const std::function<void(double part_done)>& after_each)
{
    return trace_spectrum(device, skin, wavelengths, request, nullptr,
                          [&](double part, const auto&) { after_each(part); });
}

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// R(r) of skin at many wavelengths: photons of each base, added up by their shares.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/profile.hpp"
#include "photon/bins.hpp"
#include "skin/base_tracer.hpp"
#include "skin/collected_rings.hpp"
#include "skin/resumable.hpp"

namespace gonio {
namespace {

/// Errors of a wavelength's rings over those that are asked for, the larger of both.
double times_wanted(const std::vector<Fraction>& rings, const ProfileRequest& request)
{
    const std::vector<Fraction> densities = ring_densities(rings, request.width);
    double times = 0;
    if (request.max_error) times = largest_error(densities) / *request.max_error;
    if (request.ring_error)
        times = std::max(times, mean_relative_error(densities) / *request.ring_error);
    return times;
}

/// Of all wavelengths that a base serves the largest.
double times_wanted(const PhotonResult& found, std::size_t wavelengths,
                    const ProfileRequest& request)
{
    double largest = 0;
    for (std::size_t k = 0; k < wavelengths; ++k) {
        std::vector<Fraction> rings;
        for (std::size_t ring = 0; ring < request.rings; ++ring)
            rings.push_back(found.spectrum[ring * wavelengths + k]);
        largest = std::max(largest, times_wanted(rings, request));
    }
    return largest;
}

/// Follows the photons of all bases, each until its errors are a part of those that are asked for.
class SpectrumTracer {
public:
    SpectrumTracer(const Device& device, std::vector<LayeredMedium> media,
                   const ProfileRequest& request, const AfterLaunch& after_launch)
        : device_(device),
          bases_(spectral_bases(media, spacing_of(request))),
          wavelengths_(media.size()),
          request_(request),
          after_launch_(after_launch),
          parts_of_errors_(bases_.size(), 1)
    {
    }

    /// Errors of what lies between bases are theirs and those of interpolation, so that smaller
    /// ones may be needed than are asked for.
    RadialSpectrum trace(const nlohmann::ordered_json& from)
    {
        if (!from.is_null()) {
            state_ = from;
            parts_of_errors_ = from.at("parts_of_errors").get<std::vector<double>>();
            passes_ = from.at("passes");
        }
        for (;; ++passes_) {
            state_["parts_of_errors"] = parts_of_errors_;
            state_["passes"] = passes_;
            RadialSpectrum spectrum = trace_bases();
            if (ended_ || !to_error() || !ask_for_more(spectrum)) return spectrum;
        }
    }

private:
    bool to_error() const { return request_.max_error || request_.ring_error; }

    /// Of the bases of wavelengths whose errors are too large.
    bool ask_for_more(const RadialSpectrum& spectrum)
    {
        constexpr double least = 0.4;  // below, noise is not what is left
        bool more = false;
        for (std::size_t k = 0; k < bases_.size(); ++k) {
            double times = 0;
            for (const BaseShare& share : bases_[k].shares)
                times = std::max(times, times_wanted(spectrum.rings[share.medium], request_));
            double& part = parts_of_errors_[k];
            if (times <= 1 || part == least) continue;
            part = std::max(least, 0.9 * part / times);
            more = true;
        }
        return more;
    }

    RadialSpectrum trace_bases()
    {
        CollectedRings all(wavelengths_, request_.rings);
        RadialSpectrum spectrum{.width = request_.width};
        ended_ = true;
        for (std::size_t k = 0; k < bases_.size(); ++k) {
            BaseTracer tracer(device_, bases_, k, request_, state_["bases"][k]);
            trace(tracer, k);
            state_["bases"][k] = tracer.state();
            all.add(bases_[k], tracer.result());
            spectrum.photons.push_back(tracer.photons());
            spectrum.kernel_seconds += tracer.kernel_seconds();
            ended_ = ended_ && tracer.has_ended();
        }
        all.write(spectrum);
        return spectrum;
    }

    void trace(BaseTracer& tracer, std::size_t base)
    {
        const auto measured = [&] {
            return to_error() && tracer.batches() >= least_batches
                       ? times_wanted(tracer.result(), bases_[base].shares.size(), request_) /
                             parts_of_errors_[base]
                       : std::numeric_limits<double>::infinity();
        };
        double error = measured();
        const auto state = [&] {
            state_["bases"][base] = tracer.state();
            return state_;
        };
        while (!tracer.has_ended() && error > 1) {
            tracer.trace_batch([&] {
                const double part = std::min(std::max(tracer.part(), std::pow(error, -2)), 1.0);
                after_launch_(part_of_all((static_cast<double>(base) + part) /
                                          static_cast<double>(bases_.size())),
                              state);
            });
            error = measured();
        }
    }

    /// Nobody knows whether there is a pass after this one: if there may be, half is left.
    double part_of_all(double part_of_pass) const
    {
        const bool may_go_on = to_error() && bases_.size() > 1;
        const double begun = std::pow(0.5, passes_);
        return 1 - begun + (may_go_on ? begun / 2 : begun) * part_of_pass;
    }

    const Device& device_;
    std::vector<SpectralBase> bases_;
    std::size_t wavelengths_;
    const ProfileRequest& request_;
    const AfterLaunch& after_launch_;
    nlohmann::ordered_json state_;
    std::vector<double> parts_of_errors_;  ///< of each base
    int passes_ = 0;                       ///< before this one
    bool ended_ = false;                   ///< photons or time of every base
};

}  // namespace

RadialSpectrum trace_spectrum(const Device& device, const Skin& skin,
                              const std::vector<double>& wavelengths, const ProfileRequest& request,
                              const nlohmann::ordered_json& from, const AfterLaunch& after_launch)
{
    return SpectrumTracer(device, media_of(skin, wavelengths), request, after_launch).trace(from);
}

RadialSpectrum trace_spectrum(const Device& device, const Skin& skin,
                              const std::vector<double>& wavelengths, const ProfileRequest& request,
                              const std::function<void(double part_done)>& after_each)
{
    return trace_spectrum(device, skin, wavelengths, request, nullptr,
                          [&](double part, const auto&) { after_each(part); });
}

}  // namespace gonio

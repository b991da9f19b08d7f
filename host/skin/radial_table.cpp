// SPDX-License-Identifier: Apache-2.0
// From a job to its table of spectra by distance.
#include "skin/radial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gonio/errors.hpp"
#include "photon/bins.hpp"
#include "skin/traced_sets.hpp"

namespace gonio {

using nlohmann::ordered_json;

namespace {

/// The ladders, then the wavelength, then the distance.
const std::vector<double>& wavelengths_of(const Job& job)
{
    return (job.header.axes.end() - 2)->values;
}

/// A set's values, and what belongs beside them.
ordered_json append(Table& table, const RadialSpectrum& spectrum)
{
    std::vector<double> errors, ring_errors;
    for (const auto& rings : spectrum.rings) {
        const auto values = ring_densities(rings, spectrum.width);
        errors.push_back(largest_error(values));
        ring_errors.push_back(mean_relative_error(values));
        for (const Fraction& value : values) {
            table.values[0].push_back(value.mean);
            table.values[1].push_back(value.error);
        }
    }
    return {{"photons_of_bases", spectrum.photons},
            {"kernel_seconds", spectrum.kernel_seconds},
            {"effective_photons", spectrum.effective_photons},
            {"error_of_largest_value", errors},
            {"ring_error", ring_errors}};
}

/// Of all sets and wavelengths.
double largest_of(const ordered_json& spectra, const std::string& key)
{
    double largest = 0;
    for (const auto& spectrum : spectra)
        for (const auto& error : spectrum.at(key))  // infinite ones of a checkpoint are null
            largest = std::max(largest, error.is_null() ? INFINITY : error.get<double>());
    return largest;
}

void require(const Job& job, const std::optional<double>& wanted, double reached,
             const std::string& of_what, std::uint64_t photons)
{
    if (!wanted || reached <= *wanted) return;
    throw RunError(fmt::format(
        "after {} photons a wavelength the largest error of table `{}` is {:.2g} of {}, "
        "and not {:.2g}; give it more, or --best-effort",
        photons, job.name, reached, of_what, *wanted));
}

}  // namespace

ordered_json make_radial_table(const Device& device, const Job& job,
                               const std::function<void(double)>& after_each)
{
    const auto trace = [&](const Skin& set, Table& table, const ordered_json& from,
                           const AfterLaunch& after_launch) {
        return append(table, trace_spectrum(device, set, wavelengths_of(job), *job.profile, from,
                                            after_launch));
    };
    const TracedSets traced = trace_sets(job, after_each, trace);
    std::uint64_t photons = UINT64_MAX;  // that each wavelength sees, at least
    double seconds = 0;
    for (const auto& spectrum : traced.beside) {
        for (const std::uint64_t each : spectrum.at("photons_of_bases"))
            photons = std::min(photons, each);
        seconds += spectrum.at("kernel_seconds").get<double>();
    }
    if (job.must_reach) {
        require(job, job.profile->max_error, largest_of(traced.beside, "error_of_largest_value"),
                "a wavelength's largest value", photons);
        require(job, job.profile->ring_error, largest_of(traced.beside, "ring_error"),
                "the values, in a wavelength's root mean square,", photons);
    }
    write_table(job.path, job.format, traced.table, job.write);
    const bool rings = job.profile->ring_error.has_value();
    return {{"photons", photons},
            {"kernel_seconds", seconds},
            {"error", largest_of(traced.beside, rings ? "ring_error" : "error_of_largest_value")},
            {"error_of", rings ? "each ring, in the root of their mean square"
                               : "a wavelength's largest value"},
            {"spectra", traced.beside}};
}

}  // namespace gonio

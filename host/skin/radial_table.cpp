// SPDX-License-Identifier: Apache-2.0
// From a job to its table of spectra by distance.
#include "skin/radial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "gonio/errors.hpp"
#include "photon/bins.hpp"
#include "skin/skin_sets.hpp"

namespace gonio {
namespace {

/// Per area of the rings, and the errors behind.
std::vector<Fraction> densities(const std::vector<Fraction>& rings, double width)
{
    std::vector<Fraction> all;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const double area = ring_area(k, width);
        all.push_back({rings[k].mean / area, rings[k].error / area});
    }
    return all;
}

/// The ladders, then the wavelength, then the distance.
const std::vector<double>& wavelengths_of(const Job& job)
{
    return (job.header.axes.end() - 2)->values;
}

}  // namespace

nlohmann::ordered_json make_radial_table(const Device& device, const Job& job,
                                         const std::function<void(double)>& after_each)
{
    const auto sets = sets_of(*job.skin);
    Table table{job.header, std::vector<std::vector<double>>(2)};
    nlohmann::ordered_json found = nlohmann::ordered_json::array();
    std::uint64_t photons = UINT64_MAX;  // that each wavelength sees, at least
    double seconds = 0, largest = 0;
    for (std::size_t set = 0; set < sets.size(); ++set) {
        const auto spectrum =
            trace_spectrum(device, sets[set], wavelengths_of(job), *job.profile, [&](double part) {
                after_each((static_cast<double>(set) + part) / static_cast<double>(sets.size()));
            });
        std::vector<double> errors;
        for (const auto& rings : spectrum.rings) {
            const auto values = densities(rings, spectrum.width);
            errors.push_back(largest_error(values));
            for (const Fraction& value : values) {
                table.values[0].push_back(value.mean);
                table.values[1].push_back(value.error);
            }
        }
        largest = std::max(largest, *std::ranges::max_element(errors));
        found.push_back({{"photons_of_bases", spectrum.photons},
                         {"effective_photons", spectrum.effective_photons},
                         {"error_of_largest_value", errors}});
        photons = std::min(photons, *std::ranges::min_element(spectrum.photons));
        seconds += spectrum.kernel_seconds;
    }
    if (job.must_reach && largest > *job.profile->max_error)
        throw RunError(
            fmt::format("after {} photons a wavelength the largest error of table `{}` is {:.2g} "
                        "of a wavelength's largest "
                        "value, and not {:.2g}; give it more, or --best-effort",
                        photons, job.name, largest, *job.profile->max_error));
    write_table(job.path, job.format, table, job.write);
    return {{"photons", photons}, {"kernel_seconds", seconds}, {"spectra", found}};
}

}  // namespace gonio

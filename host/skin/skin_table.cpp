// SPDX-License-Identifier: Apache-2.0
// From a job to its table of spectra, colours or light that goes through.
#include "skin/skin_table.hpp"

#include <algorithm>
#include <mutex>

#include "gonio/colour.hpp"
#include "scene/located.hpp"
#include "skin/skin_sets.hpp"
#include "skin/transmittance.hpp"

namespace gonio {
namespace {

using Channels = std::vector<std::vector<double>>;

Channels colours_of(const std::vector<SkinSpectrum>& spectra, bool rgb)
{
    Channels channels(3);
    for (const SkinSpectrum& spectrum : spectra) {
        const auto colour = colour_of(spectrum.wavelengths, spectrum.reflectance);
        for (int c = 0; c < 3; ++c)
            channels[static_cast<std::size_t>(c)].push_back(rgb ? colour.linear[c] : colour.xyz[c]);
    }
    return channels;
}

/// Of what goes through; 1 is white.
Channels colours_of(const FoldSpectra& folds, const std::vector<double>& wavelengths)
{
    Channels channels(3);
    for (const auto& spectrum : folds.transmittance) {
        const auto linear = linear_srgb(tristimulus(wavelengths, spectrum));
        for (int c = 0; c < 3; ++c) channels[static_cast<std::size_t>(c)].push_back(linear[c]);
    }
    return channels;
}

/// From [set, thickness][wavelength] to a table over set, wavelength, thickness.
Channels by_wavelength(const FoldSpectra& folds, std::size_t thicknesses)
{
    Channels channels(1);
    const auto& all = folds.transmittance;
    for (std::size_t set = 0; set < all.size(); set += thicknesses)
        for (std::size_t k = 0; k < all[set].size(); ++k)
            for (std::size_t d = 0; d < thicknesses; ++d) channels[0].push_back(all[set + d][k]);
    channels.emplace_back(channels[0].size(), folds.error);
    return channels;
}

/// The values of a table, and their error.
struct Solved {
    Channels values;
    double error = 0;
};

Solved solve(const Job& job, const std::function<void()>& after_each)
{
    const SkinTask& task = *job.skin;
    const std::string& quantity = job.header.quantity;
    if (quantity.starts_with("transmittance")) {
        const auto& thicknesses = job.header.axes.back().values;
        const FoldSpectra folds = solve_folds(task, thicknesses, after_each);
        return {quantity == "transmittance_d" ? by_wavelength(folds, thicknesses.size())
                                              : colours_of(folds, task.wavelengths),
                folds.error};
    }
    const auto spectra =
        solve_skin(sets_of(task), task.wavelengths, task.light, task.tolerance, after_each);
    return {quantity == "reflectance_spectrum" ? spectrum_channels(spectra)
                                               : colours_of(spectra, quantity == "colour_rgb"),
            spectra.front().error};
}

/// What has to be solved: each cell, and where colours are asked for each of their wavelengths.
double amount(const Job& job)
{
    const auto cells = static_cast<double>(job.header.cells());
    const bool spectrum =
        std::ranges::find(job.header.axes, "wavelength", &Axis::name) != job.header.axes.end();
    return spectrum ? cells : cells * static_cast<double>(job.skin->wavelengths.size());
}

}  // namespace

nlohmann::ordered_json make_skin_table(const Job& job,
                                       const std::function<void(double)>& after_each)
{
    return located(job.where, [&]() -> nlohmann::ordered_json {
        const double all = amount(job);
        double done = 0;
        std::mutex guard;
        Solved solved = solve(job, [&] {
            const std::scoped_lock lock(guard);
            after_each(++done / all);
        });
        write_table(job.path, job.format, {job.header, std::move(solved.values)}, job.write);
        return {{"sets", sets_of(*job.skin).size()},
                {"wavelengths", job.skin->wavelengths.size()},
                {"error", solved.error},
                {"error_of", "the light"}};
    });
}

}  // namespace gonio

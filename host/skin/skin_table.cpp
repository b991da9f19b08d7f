// SPDX-License-Identifier: Apache-2.0
// From a job to its table of spectra or colours.
#include "skin/skin_table.hpp"

#include "gonio/colour.hpp"
#include "scene/located.hpp"
#include "skin/skin_sets.hpp"

namespace gonio {
namespace {

std::vector<std::vector<double>> colours_of(const std::vector<SkinSpectrum>& spectra, bool rgb)
{
    std::vector<std::vector<double>> channels(3);
    for (const SkinSpectrum& spectrum : spectra) {
        const auto colour = colour_of(spectrum.wavelengths, spectrum.reflectance);
        for (int c = 0; c < 3; ++c)
            channels[static_cast<std::size_t>(c)].push_back(rgb ? colour.linear[c] : colour.xyz[c]);
    }
    return channels;
}

}  // namespace

nlohmann::ordered_json make_skin_table(const Job& job, const std::function<void()>& after_each)
{
    const SkinTask& task = *job.skin;
    return located(job.where, [&]() -> nlohmann::ordered_json {
        const auto spectra =
            solve_skin(sets_of(task), task.wavelengths, task.light, task.tolerance, after_each);
        Table table{job.header, {}};
        if (job.header.quantity == "reflectance_spectrum")
            table.values = spectrum_channels(spectra);
        else
            table.values = colours_of(spectra, job.header.quantity == "colour_rgb");
        write_table(job.path, job.format, table, job.write);
        return {{"sets", spectra.size()},
                {"wavelengths", task.wavelengths.size()},
                {"error", spectra.front().error}};
    });
}

}  // namespace gonio

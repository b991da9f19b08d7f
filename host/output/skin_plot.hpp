// SPDX-License-Identifier: Apache-2.0
// Pictures of skin: spectra, and the colours that they have in daylight.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gonio {

/// A curve, drawn in its own colour.
struct PlottedSpectrum {
    std::string label;
    std::vector<double> wavelengths, reflectance;  ///< nm; 1
    bool dotted = false;                           ///< points: a measurement
};

/// .png or .svg. Spectra have a colour if has_colour(). Throws UsageError for another ending,
/// RunError.
void write_skin_plot(const std::filesystem::path& path, const std::string& title,
                     const std::string& subtitle, const std::vector<PlottedSpectrum>& spectra);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Refuses what is no reflectance spectrum.
#include "skin/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "gonio/errors.hpp"

namespace gonio::skin {
namespace {

constexpr double widest_step = 20;  // nm; wider ones would miss the bands of haemoglobin
constexpr double largest = 1.2;     // brighter than white: a little, from calibration

}  // namespace

Spectrum read_measured(const std::filesystem::path& path, std::string_view column)
{
    std::ifstream file(path);
    if (!file) throw UsageError(fmt::format("{}: cannot be read", path.string()));
    Spectrum spectrum = read_spectrum(file, path.string(), column);
    const auto& wavelengths = spectrum.wavelengths();
    const auto& values = spectrum.values();
    if (*std::ranges::max_element(values) > 2)
        throw UsageError(
            fmt::format("{}: reflectances up to {} are per cent; divide them by 100, as fractions "
                        "of 0 to 1 are wanted",
                        path.string(), *std::ranges::max_element(values)));
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!(values[k] >= 0 && values[k] <= largest))
            throw UsageError(fmt::format("{}: the reflectance at {} nm is {}; allowed is 0 to 1",
                                         path.string(), wavelengths[k], values[k]));
        if (k > 0 && wavelengths[k] - wavelengths[k - 1] > widest_step)
            throw UsageError(
                fmt::format("{}: a gap from {} to {} nm; steps of up to {} nm are "
                            "allowed",
                            path.string(), wavelengths[k - 1], wavelengths[k], widest_step));
    }
    return spectrum;
}

}  // namespace gonio::skin

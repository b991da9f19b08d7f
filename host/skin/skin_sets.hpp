// SPDX-License-Identifier: Apache-2.0
// Sets of parameters of one model of skin, and the table of their spectra.
#pragma once

#include <string>
#include <vector>

#include "gonio/skin.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// A parameter that takes several values, which ascend or descend.
struct SkinLadder {
    std::string parameter;
    std::vector<double> values;
};

/// What spectra are asked for, and how exact.
struct SkinTask {
    Skin skin;
    std::vector<SkinLadder> ladders = {};  ///< from the outermost
    std::vector<double> wavelengths = {};  ///< nm
    LightSource light = {};
    double tolerance = 1e-4;
};

/// Every combination of the ladders' values, the last ladder fastest. Throws as Skin::set() does.
std::vector<Skin> sets_of(const SkinTask& task);

/// 380 to 780 nm in steps of 5.
std::vector<double> default_wavelengths();

/// "melanin 0.05": the ladders' numbers in one of the sets; empty where there is no ladder.
std::string label_of(const SkinTask& task, const Skin& set);

/// "melanin 0.05, blood 0.002, thickness 0.006 cm": the numbers that no ladder changes.
std::string fixed_text(const SkinTask& task);

/// Axes: the ladders, then the wavelength. Channels: reflectance, specular (a part of it),
/// transmittance, bottom, one for each layer, and the bound of their errors. Colours are
/// attributes, set after set, where the wavelengths have one.
Table spectrum_table(const SkinTask& task, const std::vector<SkinSpectrum>& spectra);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Sets of parameters of one model of skin, and the table of their spectra.
#pragma once

#include <string>
#include <vector>

#include "gonio/quantity.hpp"
#include "gonio/scene.hpp"
#include "gonio/skin.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// Every combination of the ladders' values, the last ladder fastest. Throws as Skin::set() does.
std::vector<Skin> sets_of(const SkinTask& task);

/// "melanin 0.05": the ladders' numbers in one of the sets; empty where there is no ladder.
std::string label_of(const SkinTask& task, const Skin& set);

/// "melanin 0.05, blood 0.002, thickness 0.006 cm": the numbers that no ladder changes.
std::string fixed_text(const SkinTask& task);

/// What all tables of skin have: the ladders as axes, the model and its parameters as attributes.
TableHeader sets_header(const SkinTask& task, const Quantity& quantity);

/// Those of the request's axes, else those that colours are summed over; nm.
std::vector<double> wavelengths_of(const TableRequest& request);

/// A table without noise. Axes: the ladders, then `own`. Channels of a spectrum: reflectance,
/// specular (a part of it), transmittance, bottom, one for each layer, and the bound of their
/// errors.
TableHeader skin_header(const SkinTask& task, const Quantity& quantity,
                        const std::vector<Axis>& own);

/// The values of such a table, set after set.
std::vector<std::vector<double>> spectrum_channels(const std::vector<SkinSpectrum>& spectra);

/// Header and values of spectra. Colours are attributes, set after set, where the wavelengths have
/// one.
Table spectrum_table(const SkinTask& task, const std::vector<SkinSpectrum>& spectra);

}  // namespace gonio

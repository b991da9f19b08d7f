// SPDX-License-Identifier: Apache-2.0
// How spectra of skin are printed.
#pragma once

#include "skin/skin_sets.hpp"

namespace gonio {

/// A line for each wavelength and a column for each set, with their colours.
void print_spectra(const SkinTask& task, const std::vector<Skin>& sets,
                   const std::vector<SkinSpectrum>& spectra);

void print_spectra_json(const SkinTask& task, const std::vector<Skin>& sets,
                        const std::vector<SkinSpectrum>& spectra);

}  // namespace gonio

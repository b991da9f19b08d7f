// SPDX-License-Identifier: Apache-2.0
// What layers of skin are made of.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gonio/layers.hpp"
#include "gonio/scene.hpp"
#include "skin/law.hpp"
#include "skin/spectrum.hpp"

namespace gonio::skin {

struct Substance;

/// So much of a substance; without an amount it is the rest of the volume.
struct Part {
    std::string name;
    std::shared_ptr<const Substance> of;
    std::optional<Amount> amount;
};

/// What absorbs: the sum of all that it has.
struct Substance {
    Law law = {};                                    ///< 1/cm
    std::shared_ptr<const Spectrum> spectrum = {};   ///< nullptr if there is none
    double unit = 1;                                 ///< of the spectrum: 1/cm, or 1/(cm g/L)
    bool needs_concentration = false;                ///< its spectrum is in 1/(cm g/L)
    std::vector<Part> mixture = {}, dissolved = {};  ///< amounts: volume fractions; g/L
    Where where = {};

    /// 1/cm, or 1/(cm g/L). Throws UsageError where the wavelength (nm) is outside of a spectrum,
    /// fractions are not in [0, 1] or sum past 1, or concentrations are below 0.
    double absorption(double wavelength, Values values) const;
    /// Calls visit(spectrum) for each that it is made of.
    template <class Visit>
    void for_spectra(const Visit& visit) const
    {
        if (spectrum) visit(*spectrum);
        for (const auto* parts : {&mixture, &dissolved})
            for (const Part& part : *parts) part.of->for_spectra(visit);
    }
};

struct LayerRecipe {
    std::optional<Amount> thickness;  ///< cm; infinite without
    Law n;
    std::shared_ptr<const Substance> absorption;
    Law scattering;        ///< 1/cm
    bool reduced = false;  ///< scattering is mus (1 - g)
    std::optional<Law> g;  ///< of Henyey-Greenstein
    PhaseFunction phase;   ///< else

    Layer at(double wavelength, Values values) const;
};

struct Recipe {
    LayeredMedium around;  ///< without its layers
    std::vector<LayerRecipe> layers = {};
    double least_wavelength = 0, greatest_wavelength = 0;  ///< nm
    std::string least_by = {}, greatest_by = {};           ///< the spectra that say so
    Where where = {};
};

}  // namespace gonio::skin

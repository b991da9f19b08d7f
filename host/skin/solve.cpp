// SPDX-License-Identifier: Apache-2.0
// Spectra of skin by adding-doubling.
#include "gonio/skin.hpp"
#include "skin/spectral_budgets.hpp"

namespace gonio {
namespace {

SkinSpectrum spectrum_of(const std::vector<double>& wavelengths,
                         const std::vector<reference::LightBudget>& budgets, double error)
{
    SkinSpectrum spectrum;
    spectrum.wavelengths = wavelengths;
    spectrum.error = error;
    spectrum.absorption.resize(budgets.front().absorption.size());
    for (const reference::LightBudget& budget : budgets) {
        spectrum.reflectance.push_back(budget.specular + budget.diffuse_reflectance);
        spectrum.specular.push_back(budget.specular);
        spectrum.transmittance.push_back(budget.unscattered_transmittance +
                                         budget.diffuse_transmittance);
        spectrum.bottom.push_back(budget.bottom_absorption);
        for (std::size_t layer = 0; layer < budget.absorption.size(); ++layer)
            spectrum.absorption[layer].push_back(budget.absorption[layer]);
    }
    return spectrum;
}

}  // namespace

std::vector<SkinSpectrum> solve_skin(const std::vector<Skin>& sets,
                                     const std::vector<double>& wavelengths,
                                     const LightSource& light, double tolerance,
                                     const std::function<void()>& after_each)
{
    const SpectralMedia media{sets.size(), wavelengths.size(), [&](std::size_t set, std::size_t k) {
                                  return sets[set].layers_at(wavelengths[k]);
                              }};
    const SpectralBudgets budgets = solve_budgets(media, light, tolerance, after_each);
    std::vector<SkinSpectrum> spectra;
    for (const auto& of_set : budgets.of)
        spectra.push_back(spectrum_of(wavelengths, of_set, budgets.error));
    return spectra;
}

}  // namespace gonio

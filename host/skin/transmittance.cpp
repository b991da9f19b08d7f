// SPDX-License-Identifier: Apache-2.0
// Folds of one set follow each other: those that are thick share what lies outside their middle.
#include "skin/transmittance.hpp"

#include "skin/fold.hpp"
#include "skin/skin_sets.hpp"
#include "skin/spectral_budgets.hpp"

namespace gonio {

FoldSpectra solve_folds(const SkinTask& task, const std::vector<double>& thicknesses,
                        const std::function<void()>& after_each)
{
    const auto sets = sets_of(task);
    const std::size_t each = thicknesses.size();
    const SpectralMedia media{
        sets.size() * each, task.wavelengths.size(), [&](std::size_t which, std::size_t k) {
            const LayeredMedium skin = sets[which / each].layers_at(task.wavelengths[k]);
            return fold_of(skin, thicknesses[which % each]);
        }};
    const SpectralBudgets budgets = solve_budgets(media, task.light, task.tolerance, after_each);
    FoldSpectra spectra{{}, budgets.error};
    for (const auto& of_fold : budgets.of) {
        auto& transmittance = spectra.transmittance.emplace_back();
        for (const reference::LightBudget& budget : of_fold)
            transmittance.push_back(budget.unscattered_transmittance +
                                    budget.diffuse_transmittance);
    }
    return spectra;
}

}  // namespace gonio

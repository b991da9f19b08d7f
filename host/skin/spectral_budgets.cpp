// SPDX-License-Identifier: Apache-2.0
// Wavelengths are shared among threads; at each of them its sets are solved one after the other.
#include "skin/spectral_budgets.hpp"

#include <algorithm>

#include "parallel.hpp"
#include "reference/adding_doubling/directions.hpp"
#include "reference/adding_doubling/slab_memory.hpp"

namespace gonio {
namespace {

constexpr std::size_t sharing = 512;         // sets that are solved together
constexpr std::size_t between_samples = 16;  // spectra are smooth, and so is their error

/// The first, the last and every sixteenth.
std::vector<std::size_t> spread(std::size_t count)
{
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k + 1 < count; k += between_samples) chosen.push_back(k);
    chosen.push_back(count - 1);
    return chosen;
}

/// How many nodes each wavelength needs, and the largest error that they leave.
struct Rule {
    std::vector<int> nodes;
    double error = 0;
};

Rule rule_for(const SpectralMedia& media, const reference::LightRequest& request, double tolerance)
{
    const auto sets = spread(media.sets), wavelengths = spread(media.wavelengths);
    std::vector<int> nodes(sets.size() * wavelengths.size());
    std::vector<double> errors(nodes.size());
    in_parallel(nodes.size(), [&](std::size_t k) {
        const auto medium =
            media.at(sets[k / wavelengths.size()], wavelengths[k % wavelengths.size()]);
        // The error that is known is that of the coarser one of two solutions.
        const auto solution = reference::solve_layers_to(medium, request, tolerance);
        nodes[k] = reference::coarser(solution.nodes);
        errors[k] = solution.error;
    });
    Rule rule{std::vector<int>(media.wavelengths), *std::ranges::max_element(errors)};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t which = k % wavelengths.size();
        const std::size_t from = wavelengths[which > 0 ? which - 1 : 0];
        const std::size_t to = wavelengths[std::min(which + 1, wavelengths.size() - 1)];
        for (std::size_t at = from; at <= to; ++at)
            rule.nodes[at] = std::max(rule.nodes[at], nodes[k]);
    }
    return rule;
}

}  // namespace

SpectralBudgets solve_budgets(const SpectralMedia& media, const LightSource& light,
                              double tolerance, const std::function<void()>& after_each)
{
    const reference::LightRequest request{.incidence = {light.incidence}};
    const Rule rule = rule_for(media, request, tolerance);
    SpectralBudgets budgets{{}, rule.error};
    budgets.of.assign(media.sets, std::vector<reference::LightBudget>(media.wavelengths));
    const std::size_t blocks = (media.sets + sharing - 1) / sharing;
    in_parallel(blocks * media.wavelengths, [&](std::size_t work) {
        const std::size_t block = work / media.wavelengths, k = work % media.wavelengths;
        reference::SlabMemory slabs;
        for (std::size_t set = block * sharing; set < std::min((block + 1) * sharing, media.sets);
             ++set) {
            const auto solution = reference::solve_layers_once(media.at(set, k), request,
                                                               rule.nodes[k], std::ref(slabs));
            budgets.of[set][k] = solution.under(light).budget;
            after_each();
        }
    });
    return budgets;
}

}  // namespace gonio

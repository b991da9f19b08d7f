// SPDX-License-Identifier: Apache-2.0
// Spectra of skin by adding-doubling, wavelengths shared among threads.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "gonio/errors.hpp"
#include "gonio/skin.hpp"
#include "parallel.hpp"
#include "reference/adding_doubling.hpp"
#include "reference/adding_doubling/directions.hpp"
#include "reference/adding_doubling/slab_memory.hpp"

namespace gonio {
namespace {

constexpr double first_nodes = 23, most_nodes = 512;  // of a hemisphere
constexpr std::size_t sharing = 512;                  // sets that are solved together
constexpr std::size_t between_samples = 16;           // spectra are smooth, and so is their error

/// All sets at all wavelengths, counted set after set.
struct Problem {
    const std::vector<Skin>& sets;
    const std::vector<double>& wavelengths;
    const LightSource& light;

    LayeredMedium medium(std::size_t which) const
    {
        const Skin& set = sets[which / wavelengths.size()];
        return set.layers_at(wavelengths[which % wavelengths.size()]);
    }

    reference::LightRequest request() const { return {.incidence = {light.incidence}}; }
};

/// A number of nodes and the error that it leaves.
struct Rule {
    int nodes = 0;
    double error = 0;
};

/// The first of 16, 23, 32, 45, … nodes whose difference to the next ones is small enough.
Rule rule_for(const Problem& problem, std::size_t which, double tolerance)
{
    const LayeredMedium medium = problem.medium(which);
    double error = 0;
    for (double next = first_nodes; next < most_nodes; next *= std::numbers::sqrt2) {
        const int nodes = static_cast<int>(std::lround(next));
        error = reference::solve_layers(medium, problem.request(), nodes).error;
        if (error <= tolerance) return {reference::coarser(nodes), error};
    }
    throw RunError(
        fmt::format("adding-doubling reached an error of {:.1e} and not {:.1e} with {} "
                    "nodes",
                    error, tolerance, most_nodes));
}

/// The rule that is enough at the first, the last and every sixteenth wavelength of the first, the
/// last and every sixteenth set.
Rule rule_for_all(const Problem& problem, double tolerance)
{
    const auto spread = [](std::size_t count) {
        std::vector<std::size_t> chosen;
        for (std::size_t k = 0; k + 1 < count; k += between_samples) chosen.push_back(k);
        chosen.push_back(count - 1);
        return chosen;
    };
    std::vector<std::size_t> samples;
    for (const std::size_t set : spread(problem.sets.size()))
        for (const std::size_t k : spread(problem.wavelengths.size()))
            samples.push_back(set * problem.wavelengths.size() + k);
    std::vector<Rule> rules(samples.size());
    in_parallel(samples.size(),
                [&](std::size_t k) { rules[k] = rule_for(problem, samples[k], tolerance); });
    Rule rule;
    for (const Rule& each : rules) {
        rule.nodes = std::max(rule.nodes, each.nodes);
        rule.error = std::max(rule.error, each.error);
    }
    return rule;
}

SkinSpectrum empty_spectrum(const Skin& skin, const std::vector<double>& wavelengths, double error)
{
    const std::vector<double> zeros(wavelengths.size());
    return {.wavelengths = wavelengths,
            .reflectance = zeros,
            .specular = zeros,
            .transmittance = zeros,
            .bottom = zeros,
            .absorption = {skin.model().layers.size(), zeros},
            .error = error};
}

void store(const reference::LightBudget& budget, std::size_t k, SkinSpectrum& spectrum)
{
    spectrum.reflectance[k] = budget.specular + budget.diffuse_reflectance;
    spectrum.specular[k] = budget.specular;
    spectrum.transmittance[k] = budget.unscattered_transmittance + budget.diffuse_transmittance;
    spectrum.bottom[k] = budget.bottom_absorption;
    for (std::size_t layer = 0; layer < budget.absorption.size(); ++layer)
        spectrum.absorption[layer][k] = budget.absorption[layer];
}

}  // namespace

std::vector<SkinSpectrum> solve_skin(const std::vector<Skin>& sets,
                                     const std::vector<double>& wavelengths,
                                     const LightSource& light, double tolerance,
                                     const std::function<void()>& after_each)
{
    const Problem problem{sets, wavelengths, light};
    const Rule rule = rule_for_all(problem, tolerance);
    std::vector<SkinSpectrum> spectra;
    for (const Skin& skin : sets) spectra.push_back(empty_spectrum(skin, wavelengths, rule.error));
    // Sets that differ in the melanin of one layer share all others at a wavelength.
    const std::size_t each = wavelengths.size();
    const std::size_t blocks = (sets.size() + sharing - 1) / sharing;
    in_parallel(blocks * each, [&](std::size_t work) {
        const std::size_t block = work / each, k = work % each;
        reference::SlabMemory slabs;
        for (std::size_t set = block * sharing; set < std::min((block + 1) * sharing, sets.size());
             ++set) {
            const auto solution = reference::solve_layers_once(
                problem.medium(set * each + k), problem.request(), rule.nodes, std::ref(slabs));
            store(solution.under(light).budget, k, spectra[set]);
            after_each();
        }
    });
    return spectra;
}

}  // namespace gonio

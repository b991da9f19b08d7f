// SPDX-License-Identifier: Apache-2.0
// Wavelengths are shared among threads; at each of them its sets are solved one after the other.
#include "skin/spectral_budgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "gonio/errors.hpp"
#include "parallel.hpp"
#include "photon/exact_values.hpp"
#include "reference/adding_doubling/directions.hpp"
#include "reference/adding_doubling/slab_memory.hpp"

namespace gonio {
namespace {

constexpr int least_nodes = 17, most_nodes = 512;  // of a hemisphere
constexpr double step = 1.189207115002721;         // 2^(1/4)
constexpr std::size_t sharing = 512;               // sets that are solved together
constexpr std::size_t between_samples = 16;        // spectra are smooth, and so is their error

/// The first, the last and every sixteenth.
std::vector<std::size_t> spread(std::size_t count)
{
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k + 1 < count; k += between_samples) chosen.push_back(k);
    chosen.push_back(count - 1);
    return chosen;
}

/// A number of nodes and the error that it leaves.
struct Rule {
    int nodes = 0;
    double error = 0;
};

/// Tries numbers of nodes, each 2^(1/4) times the one before.
class Search {
public:
    Search(const LightSource& light, double tolerance) : light_(light), tolerance_(tolerance) {}

    /// The first from `least` on whose difference to the next but one is small enough.
    Rule operator()(const LayeredMedium& medium, int least) const
    {
        const reference::LightRequest request{.incidence = {light_.incidence}};
        std::deque<std::vector<double>> found;
        double error = 0, nodes = least;
        for (; nodes <= most_nodes; nodes *= step) {
            const auto solution = reference::solve_layers_once(medium, request, whole(nodes));
            found.push_back(parts_of(solution.under(light_).budget));
            if (found.size() < 3) continue;
            error = 0;
            for (std::size_t k = 0; k < found[0].size(); ++k)
                error = std::max(error, std::abs(found[2][k] - found[0][k]));
            error *= reference::error_over_difference;
            if (error <= tolerance_) return {whole(nodes / (step * step)), error};
            found.pop_front();
        }
        throw RunError(fmt::format(
            "adding-doubling reached an error of {:.1e} and not {:.1e} with {:.0f} nodes", error,
            tolerance_, nodes / step));
    }

private:
    static int whole(double nodes) { return static_cast<int>(std::lround(nodes)); }

    LightSource light_;
    double tolerance_;
};

/// How many nodes each wavelength needs, and the largest error that they leave.
struct Rules {
    std::vector<int> nodes;
    double error = 0;
};

Rules rules_for(const SpectralMedia& media, const LightSource& light, double tolerance)
{
    const Search search(light, tolerance);
    const auto sets = spread(media.sets), wavelengths = spread(media.wavelengths);
    // Red light, which is absorbed least, is easy: nothing needs much less.
    const Rule last = search(media.at(0, wavelengths.back()), least_nodes);
    std::vector<Rule> found(sets.size() * wavelengths.size());
    in_parallel(found.size(), [&](std::size_t k) {
        if (k + 1 == wavelengths.size()) return void(found[k] = last);
        const auto medium =
            media.at(sets[k / wavelengths.size()], wavelengths[k % wavelengths.size()]);
        found[k] = search(medium, last.nodes);
    });
    Rules rules{std::vector<int>(media.wavelengths), 0};
    for (std::size_t k = 0; k < found.size(); ++k) {
        const std::size_t which = k % wavelengths.size();
        const std::size_t from = wavelengths[which > 0 ? which - 1 : 0];
        const std::size_t to = wavelengths[std::min(which + 1, wavelengths.size() - 1)];
        for (std::size_t at = from; at <= to; ++at)
            rules.nodes[at] = std::max(rules.nodes[at], found[k].nodes);
        rules.error = std::max(rules.error, found[k].error);
    }
    return rules;
}

}  // namespace

SpectralBudgets solve_budgets(const SpectralMedia& media, const LightSource& light,
                              double tolerance, const std::function<void()>& after_each)
{
    const reference::LightRequest request{.incidence = {light.incidence}};
    const Rules rules = rules_for(media, light, tolerance);
    SpectralBudgets budgets{{}, rules.error};
    budgets.of.assign(media.sets, std::vector<reference::LightBudget>(media.wavelengths));
    const std::size_t blocks = (media.sets + sharing - 1) / sharing;
    in_parallel(blocks * media.wavelengths, [&](std::size_t work) {
        const std::size_t block = work / media.wavelengths, k = work % media.wavelengths;
        reference::SlabMemory slabs;
        for (std::size_t set = block * sharing; set < std::min((block + 1) * sharing, media.sets);
             ++set) {
            const auto solution = reference::solve_layers_once(media.at(set, k), request,
                                                               rules.nodes[k], std::ref(slabs));
            budgets.of[set][k] = solution.under(light).budget;
            after_each();
        }
    });
    return budgets;
}

}  // namespace gonio

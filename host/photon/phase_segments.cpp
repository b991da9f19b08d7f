// SPDX-License-Identifier: Apache-2.0
// Aliases for the intervals of a tabulated phase function: Vose, A Linear Algorithm for Generating
// Random Numbers with a Given Distribution, IEEE Trans. Software Eng. 17(9), 1991.
#include "photon/phase_segments.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "gonio/shared/photon_fields.h"

namespace gonio {
namespace {

struct Alias {
    double share = 1;
    std::size_t other = 0;
};

/// For probabilities in any scale.
std::vector<Alias> aliases_of(std::vector<double> weights)
{
    const double mean =
        std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    std::vector<Alias> aliases(weights.size());
    std::vector<std::size_t> small, large;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        weights[k] /= mean;
        (weights[k] < 1 ? small : large).push_back(k);
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t less = small.back(), more = large.back();
        small.pop_back();
        aliases[less] = {weights[less], more};
        weights[more] -= 1 - weights[less];
        if (weights[more] >= 1) continue;
        large.pop_back();
        small.push_back(more);
    }
    return aliases;  // what is left over has a weight of 1 but for rounding
}

}  // namespace

std::vector<float> phase_segments(const TabulatedPhase& phase)
{
    const std::size_t count = phase.cosine.size() - 1;
    const double largest = std::ranges::max(phase.value);
    std::vector<double> weights;
    for (std::size_t k = 0; k < count; ++k)
        weights.push_back((phase.value[k] + phase.value[k + 1]) *
                          (phase.cosine[k + 1] - phase.cosine[k]));
    const std::vector<Alias> aliases = aliases_of(weights);
    std::vector<float> records(count * segment_fields);
    for (std::size_t k = 0; k < count; ++k) {
        float* record = &records[k * segment_fields];
        const auto set = [&](segment_field field, double value) {
            record[field] = static_cast<float>(value);
        };
        set(segment_share, aliases[k].share);
        set(segment_alias, static_cast<double>(aliases[k].other));
        set(segment_low, phase.value[k] / largest);
        set(segment_high, phase.value[k + 1] / largest);
        set(segment_end, 1 - phase.cosine[k + 1]);
        set(segment_width, phase.cosine[k + 1] - phase.cosine[k]);
    }
    return records;
}

}  // namespace gonio

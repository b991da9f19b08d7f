// SPDX-License-Identifier: Apache-2.0
// Channels whose numbers all agree are one, and colours that are grey.
#include "compute/distinct_channels.hpp"

#include <algorithm>
#include <numeric>

namespace gonio {
namespace {

/// A list that has one number, or one for each channel.
double number(const std::vector<double>& numbers, std::size_t channel)
{
    return numbers[numbers.size() == 1 ? 0 : channel];
}

/// Calls visit(list) for all lists of numbers of a material, const or not.
template <class Lobes, class Visit>
void for_each_list(Lobes& lobes, const Visit& visit)
{
    for (auto& lobe : lobes) {
        for (auto& numbers : lobe.values) visit(numbers);
        visit(lobe.weight);
    }
}

bool agree(const Material& material, std::size_t a, std::size_t b)
{
    bool same = true;
    for_each_list(material.lobes, [&](const std::vector<double>& numbers) {
        same = same && number(numbers, a) == number(numbers, b);
    });
    return same;
}

bool has_tables(const Material& material)
{
    return std::ranges::any_of(material.lobes,
                               [](const Lobe& lobe) { return !lobe.tables.empty(); });
}

}  // namespace

bool all_are(const std::vector<double>& numbers, double number)
{
    return std::ranges::all_of(numbers, [&](double other) { return other == number; });
}

DistinctChannels all_channels(const Material& material)
{
    DistinctChannels all{material, std::vector<std::size_t>(material.channels())};
    std::iota(all.of.begin(), all.of.end(), std::size_t{0});
    return all;
}

DistinctChannels distinct_channels(const Material& material)
{
    if (has_tables(material)) return all_channels(material);
    DistinctChannels distinct{material, {}};
    std::vector<std::size_t> firsts;  // the channel that each distinct one is
    for (std::size_t c = 0; c < material.channels(); ++c) {
        const auto same = std::ranges::find_if(
            firsts, [&](std::size_t first) { return agree(material, first, c); });
        distinct.of.push_back(static_cast<std::size_t>(same - firsts.begin()));
        if (same == firsts.end()) firsts.push_back(c);
    }
    for_each_list(distinct.material.lobes, [&](std::vector<double>& numbers) {
        std::vector<double> kept;
        for (const std::size_t first : firsts) kept.push_back(number(numbers, first));
        if (numbers.size() > 1) numbers = kept;
    });
    return distinct;
}

}  // namespace gonio

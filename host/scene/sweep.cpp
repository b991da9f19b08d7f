// SPDX-License-Identifier: Apache-2.0
// Reads sweeps and makes their values.
#include "scene/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace gonio {
namespace {

std::vector<double> range_values(const Section& range)
{
    const Value first = range.at("from"), last = range.at("to"), samples = range.at("count");
    const double from = first.number(), to = last.number();
    const bool logarithmic = range.find("spacing") && range.at("spacing").choice({"linear", "log"});
    if (samples.is_number() && samples.number() < 2)
        samples.fail(
            fmt::format("a sweep of {} values over a range; allowed is 2 (both ends) to {}",
                        samples.number(), max_samples));
    const auto count = static_cast<std::size_t>(samples.count(2, max_samples));
    if (logarithmic && !(from > 0)) first.fail("`from` is not above 0, as spacing = \"log\" needs");
    if (logarithmic && !(to > 0)) last.fail("`to` is not above 0, as spacing = \"log\" needs");
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) {
        const double position = static_cast<double>(k) / static_cast<double>(count - 1);
        values.push_back(logarithmic ? from * std::pow(to / from, position)
                                     : from + (to - from) * position);
    }
    values.back() = to;
    return values;
}

std::vector<double> listed_values(const Value& list)
{
    auto values = list.numbers();
    if (values.empty()) list.fail("a sweep of nothing; allowed is at least one value");
    if (values.size() > max_samples)
        list.fail(fmt::format("a sweep of {} values; allowed are {}", values.size(), max_samples));
    return values;
}

bool strictly_monotonic(const std::vector<double>& values)
{
    const auto ordered = [&](auto breaks_order) {
        return std::ranges::adjacent_find(values, breaks_order) == values.end();
    };
    return ordered(std::greater_equal<>()) || ordered(std::less_equal<>());
}

bool distinct(std::vector<double> values)
{
    std::ranges::sort(values);
    return std::ranges::adjacent_find(values) == values.end();
}

}  // namespace

Sweep read_sweep(const Value& value, std::size_t part)
{
    const Section section(value);
    const bool listed = section.find("values").has_value();
    if (listed)
        section.allow({"values", "as"});
    else
        section.allow({"from", "to", "count", "spacing", "values", "as"});
    Sweep sweep{part, value.name(), {}, true, value.where()};
    if (const auto as = section.find("as")) sweep.axis = as->choice({"axis", "files"}) == 0;
    sweep.values = listed ? listed_values(section.at("values")) : range_values(section);
    if (sweep.axis && !strictly_monotonic(sweep.values))
        value.fail("the values of an axis must all ascend or all descend");
    if (!sweep.axis && !distinct(sweep.values)) value.fail("a value is there twice");
    return sweep;
}

double read_swept_number(const Value& value, std::size_t part, std::vector<Sweep>& sweeps)
{
    if (!value.is_table()) return value.number();
    sweeps.push_back(read_sweep(value, part));
    return sweeps.back().values.front();
}

}  // namespace gonio

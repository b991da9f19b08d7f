// SPDX-License-Identifier: Apache-2.0
// What a card says of its material: models, variants, and the numbers that are not defaults.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/contact_sheet.hpp"

namespace gonio {
namespace {

constexpr auto glue = "\u00a0";  // a space at which no line is broken

std::string number_text(const std::vector<double>& numbers)
{
    return numbers.size() == 1
               ? fmt::format("{:g}", numbers[0])
               : fmt::format("({:g})", fmt::join(numbers, fmt::format(",{}", glue)));
}

/// The name of a number on a card: alpha for alpha_x if alpha_y is the same, nothing for alpha_y.
std::string_view name_of(const Lobe& lobe, std::size_t index)
{
    const Parameter& parameter = lobe.model->parameters[index];
    for (const Both& both : lobe.model->both) {
        const bool first = both.first == parameter.name, second = both.second == parameter.name;
        const bool same = lobe.values[lobe.model->index_of(both.first)] ==
                          lobe.values[lobe.model->index_of(both.second)];
        if (same && first) return both.alias;
        if (same && second) return "";
    }
    return parameter.name;
}

/// "torrance_sparrow: ndf ggx, fresnel schlick, alpha 0.3"
std::string text_of(const Lobe& lobe)
{
    std::vector<std::string> variant, numbers;
    for (std::size_t p = 0; p < lobe.values.size(); ++p) {
        const Parameter& parameter = lobe.model->parameters[p];
        const std::string_view name = name_of(lobe, p);
        if (parameter.kind == Kind::choice) {
            const auto option = static_cast<std::size_t>(lobe.values[p][0]);
            variant.push_back(fmt::format("{}{}{}", name, glue, parameter.options[option].name));
        } else if (parameter.kind == Kind::table) {
            if (const auto grid = lobe.table(p))
                variant.push_back(fmt::format("{}{}{}", name, glue, grid->name));
        } else if (!name.empty() && lobe.values[p] != std::vector{parameter.preset}) {
            numbers.push_back(fmt::format("{}{}{}{}", name, glue, number_text(lobe.values[p]),
                                          parameter.unit == "deg" ? "°" : ""));
        }
    }
    if (lobe.weight != std::vector{1.0})
        numbers.push_back(fmt::format("weight{}{}", glue, number_text(lobe.weight)));
    variant.insert(variant.end(), numbers.begin(), numbers.end());
    return fmt::format("{}{}{}", lobe.model->id, variant.empty() ? "" : ": ",
                       fmt::join(variant, ", "));
}

}  // namespace

ContactCard make_card(const Material& material)
{
    std::vector<std::string> lobes;
    for (const Lobe& lobe : material.lobes) lobes.push_back(text_of(lobe));
    return {material, material.name, fmt::format("{}", fmt::join(lobes, "\n"))};
}

}  // namespace gonio

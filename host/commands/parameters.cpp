// SPDX-License-Identifier: Apache-2.0
// A model's parameters on the command line.
#include "commands/parameters.hpp"

#include <fmt/format.h>

#include <CLI/StringTools.hpp>
#include <charconv>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

void set(Lobe& lobe, const std::string& name, const std::string& value)
{
    const std::size_t index = lobe.model->index_of(name);
    if (index != Model::npos && !lobe.model->parameters[index].is_number())
        return lobe.set(name, value);
    std::vector<double> numbers;
    for (const std::string& part : CLI::detail::split(value, ','))
        numbers.push_back(number_of(part, name));
    lobe.set(name, numbers);
}

}  // namespace

double number_of(std::string_view text, std::string_view what)
{
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        throw UsageError(fmt::format("`{}` is \"{}\", which is not a number", what, text));
    return number;
}

std::vector<std::pair<std::string, std::string>> named_values(const std::vector<std::string>& words)
{
    std::vector<std::pair<std::string, std::string>> all;
    for (std::size_t k = 0; k < words.size(); ++k) {
        std::string name = words[k];
        if (!name.starts_with("--"))
            throw UsageError(
                fmt::format("what is `{}`? Parameters are written --name value", name));
        name.erase(0, 2);
        std::string value;
        if (const std::size_t equals = name.find('='); equals != std::string::npos) {
            value = name.substr(equals + 1);
            name.erase(equals);
        } else if (++k < words.size()) {
            value = words[k];
        } else {
            throw UsageError(fmt::format("--{} has no value", name));
        }
        all.emplace_back(name, value);
    }
    return all;
}

Lobe lobe_of_words(const std::string& model, const std::vector<std::string>& words)
{
    Lobe lobe = default_lobe(model);
    for (const auto& [name, value] : named_values(words)) set(lobe, name, value);
    return lobe;
}

}  // namespace gonio

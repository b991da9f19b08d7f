// SPDX-License-Identifier: Apache-2.0
// Types and ranges of the values of a scene file.
#include "scene/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gonio/model.hpp"

namespace gonio {
namespace {

std::string_view type_name(const toml::node& node)
{
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::string:
            return "a text";
        case toml::node_type::integer:
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

double number_of(const toml::node& node)
{
    if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
    return node.as_floating_point()->get();
}

std::string range_text(double least, double greatest)
{
    if (least > std::numeric_limits<double>::lowest() &&
        greatest < std::numeric_limits<double>::max()) {
        return fmt::format("{} to {}", least, greatest);
    }
    if (least > std::numeric_limits<double>::lowest()) return fmt::format("at least {}", least);
    return "a finite number";
}

}  // namespace

Where Value::where(toml::source_position position) const
{
    return fmt::format("{}:{}:{}: ", *node_->source().path, position.line, position.column);
}

void Value::fail(const std::string& message) const
{
    throw UsageError(where() + message);
}

void Value::expected(std::string_view what) const
{
    fail(fmt::format("`{}` is {}; allowed is {}", name_, type_name(*node_), what));
}

double Value::number(double least, double greatest) const
{
    if (!is_number()) expected("a number");
    const double number = number_of(*node_);
    if (!(number >= least && number <= greatest))
        fail(fmt::format("`{}` is {}; allowed is {}", name_, number, range_text(least, greatest)));
    return number;
}

std::uint64_t Value::count(std::uint64_t least, std::uint64_t greatest) const
{
    const auto allowed = fmt::format("a whole number from {} to {}", least, greatest);
    if (!is_number()) expected(allowed);
    const double number = number_of(*node_);
    if (!(number >= static_cast<double>(least) && number <= static_cast<double>(greatest)) ||
        number != std::floor(number)) {
        fail(fmt::format("`{}` is {}; allowed is {}", name_, number, allowed));
    }
    return static_cast<std::uint64_t>(number);
}

std::string Value::text() const
{
    if (!is_text()) expected("a text");
    return *node_->value<std::string>();
}

bool Value::flag() const
{
    if (!node_->is_boolean()) expected("true or false");
    return *node_->value<bool>();
}

std::size_t Value::choice(const std::vector<std::string_view>& words) const
{
    if (!is_text()) expected(fmt::format("one of \"{}\"", fmt::join(words, "\", \"")));
    const auto word = text();
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        fail(fmt::format("`{}` cannot be \"{}\"{}", name_, word, suggestion(word, words)));
    return static_cast<std::size_t>(found - words.begin());
}

std::vector<Value> Value::list() const
{
    if (!is_list()) expected("a list");
    std::vector<Value> values;
    for (const toml::node& element : *node_->as_array())
        values.emplace_back(element, fmt::format("{}[{}]", name_, values.size()),
                            element.source().begin);
    return values;
}

std::vector<double> Value::numbers() const
{
    std::vector<double> numbers;
    for (const Value& value : list()) numbers.push_back(value.number());
    return numbers;
}

const toml::table& Value::table() const
{
    if (!is_table()) expected("a table");
    return *node_->as_table();
}

void Section::allow(const std::vector<std::string_view>& keys) const
{
    for (const Value& value : values())
        if (std::ranges::find(keys, value.name()) == keys.end())
            throw UsageError(fmt::format("{}unknown key `{}`{}", value.where_key(), value.name(),
                                         suggestion(value.name(), keys)));
}

std::optional<Value> Section::find(std::string_view key) const
{
    const auto found = table_->find(key);
    if (found == table_->end()) return std::nullopt;
    return Value(found->second, std::string(key), found->first.source().begin);
}

Value Section::at(std::string_view key) const
{
    const auto value = find(key);
    if (!value) fail(fmt::format("`{}` needs a `{}`", value_.name(), key));
    return *value;
}

std::vector<Value> Section::values() const
{
    std::vector<Value> values;
    for (const auto& [key, node] : *table_)
        values.emplace_back(node, std::string(key.str()), key.source().begin);
    std::ranges::sort(values, [](const Value& a, const Value& b) { return a.stands_before(b); });
    return values;
}

}  // namespace gonio

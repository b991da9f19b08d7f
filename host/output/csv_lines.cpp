// SPDX-License-Identifier: Apache-2.0
// Lines, fields and numbers of a CSV file.
#include "output/csv_lines.hpp"

#include <fmt/format.h>

#include <charconv>

#include "gonio/errors.hpp"

namespace gonio {

bool CsvLines::next()
{
    if (!std::getline(stream_, line_)) return false;
    ++line_number_;
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    return true;
}

std::vector<std::string_view> CsvLines::fields() const
{
    std::vector<std::string_view> fields;
    const std::string_view text = line_;
    for (std::size_t start = 0; start <= text.size();) {
        const auto end = std::min(text.find(',', start), text.size());
        fields.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return fields;
}

template <class Real>
Real CsvLines::number(std::string_view field) const
{
    auto text = field;
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    Real value = 0;
    const auto end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec == std::errc::result_out_of_range) {
        fail(field, fmt::format("'{}' is out of range", field));
    }
    if (result.ec != std::errc() || result.ptr != end) {
        fail(field, fmt::format("'{}' is not a number", field));
    }
    return value;
}

template float CsvLines::number<float>(std::string_view) const;
template double CsvLines::number<double>(std::string_view) const;

void CsvLines::fail(std::string_view at, const std::string& what) const
{
    const auto column = at.data() - line_.data() + 1;
    throw UsageError(fmt::format("{}:{}:{}: {}", name_, line_number_, column, what));
}

}  // namespace gonio

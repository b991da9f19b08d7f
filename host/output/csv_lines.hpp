// SPDX-License-Identifier: Apache-2.0
// Reads a CSV file line by line and cuts numbers out of it; its errors name file:line:column.
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

class CsvLines {
public:
    /// `name` is what errors call the stream.
    CsvLines(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

    /// Goes to the next line and says whether there is one. A carriage return at its end is
    /// dropped.
    bool next();
    const std::string& line() const { return line_; }

    /// The fields of the line. They are not quoted: no name or unit holds a comma.
    std::vector<std::string_view> fields() const;

    /// The field, which must be one of fields(), as a number. Throws UsageError.
    template <class Real>
    Real number(std::string_view field) const;

    /// Throws UsageError "name:line:column: what". `at` is part of the line.
    [[noreturn]] void fail(std::string_view at, const std::string& what) const;
    [[noreturn]] void fail(const std::string& what) const { fail(line_, what); }

private:
    std::istream& stream_;
    std::string name_;
    std::string line_;
    std::size_t line_number_ = 0;
};

}  // namespace gonio

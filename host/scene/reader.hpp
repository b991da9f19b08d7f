// SPDX-License-Identifier: Apache-2.0
// Checked access to the values of a scene file: whatever is wrong is said with file:line:column.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/errors.hpp"
#include "gonio/scene.hpp"
#include "scene/located.hpp"

namespace gonio {

/// A value of the scene with its name. Each reader throws UsageError at the value's place unless
/// the value is what it reads.
class Value {
public:
    Value(const toml::node& node, std::string name, toml::source_position key)
        : node_(&node), name_(std::move(name)), key_(key)
    {
    }

    const std::string& name() const { return name_; }
    Where where() const { return where(node_->source().begin); }
    Where where_key() const { return where(key_); }
    bool stands_before(const Value& other) const { return key_ < other.key_; }
    [[noreturn]] void fail(const std::string& message) const;

    bool is_number() const { return node_->is_number(); }
    bool is_text() const { return node_->is_string(); }
    bool is_list() const { return node_->is_array(); }
    bool is_table() const { return node_->is_table(); }

    /// A whole number is a number too; infinite ones need an infinite range.
    double number(double least = std::numeric_limits<double>::lowest(),
                  double greatest = std::numeric_limits<double>::max()) const;
    /// A whole number; 1e6 is one too.
    std::uint64_t count(std::uint64_t least, std::uint64_t greatest) const;
    std::string text() const;
    bool flag() const;  ///< true or false
    /// One of the words; index in `words`.
    std::size_t choice(const std::vector<std::string_view>& words) const;
    std::vector<Value> list() const;
    std::vector<double> numbers() const;  ///< of a list
    const toml::table& table() const;

private:
    Where where(toml::source_position position) const;
    [[noreturn]] void expected(std::string_view what) const;

    const toml::node* node_;
    std::string name_;
    toml::source_position key_;
};

/// A table of the scene.
class Section {
public:
    explicit Section(const Value& value) : value_(value), table_(&value.table()) {}

    Where where() const { return value_.where(); }
    [[noreturn]] void fail(const std::string& message) const { value_.fail(message); }

    /// Throws UsageError at the first other key, with the nearest of these.
    void allow(const std::vector<std::string_view>& keys) const;

    std::optional<Value> find(std::string_view key) const;
    /// Throws UsageError if it is missing.
    Value at(std::string_view key) const;
    /// All values in the order of the file.
    std::vector<Value> values() const;

private:
    Value value_;
    const toml::table* table_;
};

}  // namespace gonio

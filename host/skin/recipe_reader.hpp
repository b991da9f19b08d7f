// SPDX-License-Identifier: Apache-2.0
// Reads the numbers, laws and substances of a model of skin: its own, and those of the library.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gonio/skin.hpp"
#include "scene/reader.hpp"
#include "skin/recipe.hpp"

namespace gonio::skin {

/// Every value that is read may name a parameter. Errors are UsageErrors with file:line:column.
class RecipeReader {
public:
    /// `places`: the model's file and the library, the first that has a name gives it. `folder`:
    /// where spectra of the model are looked for before those that are built in.
    RecipeReader(const std::vector<SkinParameter>& parameters, std::vector<Section> places,
                 std::filesystem::path folder);

    /// A number, a parameter, or a list of them, which is their product.
    Amount amount(const Value& value);
    /// A number, a parameter, a name, a list of terms, or { law, scale }.
    Law law(const Value& value);
    /// A number in 1/cm, a name, or { law, spectrum, mixture, dissolved }.
    std::shared_ptr<const Substance> substance(const Value& value);

    bool has_used(std::size_t parameter) const { return used_[parameter]; }

private:
    using Named = std::shared_ptr<const Substance>;

    std::optional<std::size_t> find_parameter(const std::string& name);
    std::optional<Value> find(std::string_view kind, const std::string& name) const;
    std::vector<std::string> names_of(std::string_view kind) const;
    Amount factor(const Value& value);
    Term term(const Value& value);
    Law terms(const Value& value);
    Named named(const Value& user, const std::string& name);
    Named read(const Value& value);
    void read_spectrum_of(const Section& spectrum, Substance& substance) const;
    std::vector<Part> mixture(const Value& value);
    std::vector<Part> dissolved(const Value& value);

    const std::vector<SkinParameter>& parameters_;
    std::vector<Section> places_;
    std::filesystem::path folder_;
    std::vector<bool> used_;
    std::map<std::string, Named> known_;  // nullptr while it is read
};

}  // namespace gonio::skin

// SPDX-License-Identifier: Apache-2.0
// The registry of reflectance models as data: what models.inc says, for validation, help, listings
// and tests.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

/// What a model or one of its options is; OR-ed together.
enum Traits : unsigned {
    PLAIN = 0,
    ONE_WAY = 1,      ///< the BRDF is not reciprocal
    EXPONENTIAL = 2,  ///< accuracy class of exponential and power lobes; algebraic without it
    VALUE = 4,        ///< prints a value that contains cos theta_i, not a BRDF in 1/sr
    CANCELS = 8,      ///< a fit whose terms cancel: accurate but for float32 directions' rounding
    MIRRORED = 16,    ///< a lobe about the mirror direction, not about the normal as half vector
    KINKED = 32,      ///< facets' masking, or cosines, change hands: quadrature splits there
    SAMPLED = 64,     ///< its kernel file has <id>_sample and <id>_pdf
};

struct Option {
    std::string_view name;
    unsigned traits;
    std::string_view doc;
};

/// How many numbers a parameter has: one, or one per channel; a choice has a name of an option, a
/// table that of a file.
enum class Kind { scalar, color, choice, table };

struct Parameter {
    Kind kind;
    std::string_view name;
    std::string_view unit;  ///< "deg" is radians inside
    double least = 0, greatest = 0;
    double preset = 0;  ///< the default; for a choice the number of the option
    std::string_view doc;
    std::vector<Option> options;  ///< of a choice

    bool is_number() const { return kind == Kind::scalar || kind == Kind::color; }
};

/// One name that sets two parameters: alpha for alpha_x and alpha_y. A material is isotropic if
/// they agree.
struct Both {
    std::string_view alias, first, second;
};

/// A parameter at one of its numbers, in every channel.
struct ParameterAt {
    std::string_view name;
    double number;
};

struct Model {
    std::string_view id, title, citation;
    unsigned traits = PLAIN;
    std::vector<Parameter> parameters;  ///< in the order of the block
    std::vector<Both> both;
    std::vector<ParameterAt> isotropic_at;  ///< it is isotropic only there
    std::vector<ParameterAt> dark_at;       ///< it reflects nothing there
    std::vector<std::string_view> notes;    ///< what a user should know: limits, our readings

    /// Index of a parameter, or npos.
    std::size_t index_of(std::string_view name) const;
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

/// A model under the name that people look for: `ggx` is torrance_sparrow with ndf = ggx. Choice
/// and option are empty where the alias only names the model.
struct Alias {
    std::string_view name, model, choice, option;
};

const std::vector<Model>& models();
const std::vector<Alias>& aliases();

/// The model of that id, or nullptr. Aliases are not resolved here: see default_lobe().
const Model* find_model(std::string_view id);

/// "; did you mean `ward`?" if one of the candidates is near, else "; known are: ...".
std::string suggestion(std::string_view wrong, const std::vector<std::string_view>& candidates);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// A model's parameters on the command line: --alpha_x 0.2, --rho_s 0.9,0.7,0.5, --ndf=beckmann.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gonio/material.hpp"

namespace gonio {

/// --name value or --name=value: what the verb's own options left over, as pairs. Throws
/// UsageError.
std::vector<std::pair<std::string, std::string>> named_values(
    const std::vector<std::string>& words);

/// The model with parameters from such words. Throws UsageError with the nearest name and the
/// allowed range.
Lobe lobe_of_words(const std::string& model, const std::vector<std::string>& words);

/// The number that is all of `text`. Throws UsageError that names `what`.
double number_of(std::string_view text, std::string_view what);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Numbers of a recipe: products with parameters, and laws of the wavelength.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gonio::skin {

/// Numbers of a model's parameters, in their order.
using Values = std::span<const double>;

/// A number times parameters of the model.
struct Amount {
    double number = 1;
    std::vector<std::size_t> parameters = {};

    double at(Values values) const;
};

Amount operator*(Amount a, const Amount& b);

/// scale (wavelength / reference)^power, or scale exp(-(wavelength - from) / decay).
struct Term {
    Amount scale;
    Amount power = {0};
    double reference = 1;              ///< nm
    double from = 0;                   ///< nm
    std::optional<double> decay = {};  ///< nm
};

/// A sum of terms.
struct Law {
    std::vector<Term> terms;

    double at(double wavelength, Values values) const;
    Law scaled(const Amount& by) const;
};

}  // namespace gonio::skin

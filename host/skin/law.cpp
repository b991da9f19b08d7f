// SPDX-License-Identifier: Apache-2.0
// Evaluates amounts and laws.
#include "skin/law.hpp"

#include <cmath>

namespace gonio::skin {

double Amount::at(Values values) const
{
    double product = number;
    for (const std::size_t parameter : parameters) product *= values[parameter];
    return product;
}

Amount operator*(Amount a, const Amount& b)
{
    a.number *= b.number;
    a.parameters.insert(a.parameters.end(), b.parameters.begin(), b.parameters.end());
    return a;
}

double Law::at(double wavelength, Values values) const
{
    double sum = 0;
    for (const Term& term : terms)
        sum += term.scale.at(values) *
               (term.decay ? std::exp(-(wavelength - term.from) / *term.decay)
                           : std::pow(wavelength / term.reference, term.power.at(values)));
    return sum;
}

Law Law::scaled(const Amount& by) const
{
    Law law = *this;
    for (Term& term : law.terms) term.scale = term.scale * by;
    return law;
}

}  // namespace gonio::skin

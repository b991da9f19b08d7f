// SPDX-License-Identifier: Apache-2.0
// Evaluates recipes at a wavelength.
#include "skin/recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gonio/errors.hpp"

namespace gonio::skin {
namespace {

constexpr double rounding = 1e-9;  // of a sum of fractions that is to be 1

/// Volume fractions, the rest included. Throws UsageError where they are no fractions of one whole.
std::vector<double> fractions(const Substance& whole, Values values)
{
    std::vector<double> all;
    for (const Part& part : whole.mixture) {
        all.push_back(part.amount ? part.amount->at(values) : 0);
        if (!(all.back() >= 0 && all.back() <= 1))
            throw UsageError(fmt::format("{}the volume fraction of `{}` is {}; allowed is 0 to 1",
                                         whole.where, part.name, all.back()));
    }
    const double sum = std::accumulate(all.begin(), all.end(), 0.0);
    if (sum > 1 + rounding)
        throw UsageError(
            fmt::format("{}the volume fractions sum to {}; allowed is 1", whole.where, sum));
    for (std::size_t k = 0; k < all.size(); ++k)
        if (!whole.mixture[k].amount) all[k] = std::max(1 - sum, 0.0);
    return all;
}

}  // namespace

double Substance::absorption(double wavelength, Values values) const
{
    double sum = law.at(wavelength, values);
    if (spectrum) sum += unit * spectrum->at(wavelength);
    const std::vector<double> shares = fractions(*this, values);
    for (std::size_t k = 0; k < mixture.size(); ++k)
        sum += shares[k] * mixture[k].of->absorption(wavelength, values);
    for (const Part& part : dissolved) {
        const double concentration = part.amount->at(values);
        if (!(concentration >= 0))
            throw UsageError(
                fmt::format("{}the concentration of `{}` is {}; allowed is 0 g/L and "
                            "more",
                            where, part.name, concentration));
        sum += concentration * part.of->absorption(wavelength, values);
    }
    return sum;
}

Layer LayerRecipe::at(double wavelength, Values values) const
{
    Layer layer;
    layer.mua = absorption->absorption(wavelength, values);
    layer.mus = scattering.at(wavelength, values);
    layer.n = n.at(wavelength, values);
    if (thickness) layer.d = thickness->at(values);
    layer.phase = phase;
    if (!g) return layer;
    const double mean_cosine = g->at(wavelength, values);
    layer.phase = HenyeyGreenstein{mean_cosine};
    if (reduced) layer.mus /= 1 - mean_cosine;
    return layer;
}

}  // namespace gonio::skin

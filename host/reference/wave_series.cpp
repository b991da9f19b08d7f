// SPDX-License-Identifier: Apache-2.0
// The series that every wave-optics model of a Gaussian surface ends in.
#include "reference/wave_series.hpp"

#include <algorithm>
#include <cmath>

namespace gonio::reference {
namespace {

/// log(e^-g g^m/m!), for large m as Loader, Fast and accurate computation of binomial
/// probabilities, 2000: the deviance m log(m/g) + g - m apart, and Stirling's series.
double log_poisson(double m, double g)
{
    if (m < 16) return m * std::log(g) - g - std::lgamma(m + 1);
    const double away = (m - g) / g;
    const double deviance = std::abs(away) < 0.5 ? g * ((1 + away) * std::log1p(away) - away)
                                                 : m * std::log(m / g) + g - m;
    const double m2 = m * m;
    const double stirling = (1.0 / 12 - (1.0 / 360 - (1.0 / 1260 - 1 / (1680 * m2)) / m2) / m2) / m;
    return -deviance - stirling - 0.5 * std::log(2 * std::numbers::pi * m);
}

/// The largest term's m: terms grow while g m/(m + 1)^2 e^(b/(m (m + 1))) > 1, which falls with m.
double peak(double g, double b)
{
    double low = 1, high = std::ceil(g + std::sqrt(b) + 2);
    while (low < high) {
        const double m = std::floor((low + high) / 2);
        const bool grows = std::log(g * m / ((m + 1) * (m + 1))) + b / (m * (m + 1)) > 0;
        (grows ? low : high) = grows ? m + 1 : m;
    }
    return low;
}

}  // namespace

double wave_series(double g, double b)
{
    if (g == 0) return 0;
    const auto log_term = [g, b](double m) { return log_poisson(m, g) - std::log(m) - b / m; };
    const double top = peak(g, b), log_top = log_term(top);

    // Far from m = 1 the terms are samples of a bell so smooth that every s-th of them, s below its
    // standard deviation, gives the sum: the error is that of the trapezoidal rule, e^(-2 (pi
    // sd/s)^2).
    const double deviation = 1 / std::sqrt(1 / top + 2 * b / (top * top * top));
    const double stride = top < 200 ? 1 : std::max(1.0, std::floor(0.6 * deviation));
    double sum = 1;
    for (const double step : {-stride, stride})
        for (double m = top + step, term = 1; m >= 1 && term > 1e-18; m += step) {
            term = std::exp(log_term(m) - log_top);
            sum += term;
        }
    return stride * sum * std::exp(log_top);
}

}  // namespace gonio::reference

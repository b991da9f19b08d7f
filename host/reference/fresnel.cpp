// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance for unpolarised light by complex arithmetic, as optics books write it.
#include "reference/fresnel.hpp"

#include <cmath>
#include <complex>

namespace gonio::reference {

double fresnel_schlick(double f0, double cos_theta)
{
    return f0 + (1 - f0) * std::pow(1 - cos_theta, 5);
}

// With N the square of the index and w = sqrt(N - sin^2) the numerators c - w of s light and
// N c - w of p light are (1 - N)/(c + w) and (N - 1)((N + 1) c^2 - 1)/(N c + w): exact for an index
// near 1, where they cancel.
double fresnel_exact(double eta, double k, double cos_theta)
{
    const std::complex<double> index(eta, k), n2 = index * index;
    const std::complex<double> excess = (index - 1.0) * (index + 1.0);
    const double cos2 = cos_theta * cos_theta;
    const std::complex<double> w = std::sqrt(excess + cos2);
    const std::complex<double> s = excess / ((cos_theta + w) * (cos_theta + w));
    const std::complex<double> below = n2 * cos_theta + w;
    const std::complex<double> p = excess * ((n2 + 1.0) * cos2 - 1.0) / (below * below);
    return 0.5 * (std::norm(s) + std::norm(p));
}

}  // namespace gonio::reference

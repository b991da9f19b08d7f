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

double fresnel_exact(double eta, double k, double cos_theta)
{
    const std::complex<double> index(eta, k);
    const double sin2 = (1 - cos_theta) * (1 + cos_theta);
    const std::complex<double> cos_inside = std::sqrt(1.0 - sin2 / (index * index));
    const std::complex<double> s =
        (cos_theta - index * cos_inside) / (cos_theta + index * cos_inside);
    const std::complex<double> p =
        (index * cos_theta - cos_inside) / (index * cos_theta + cos_inside);
    return 0.5 * (std::norm(s) + std::norm(p));
}

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// The series that every wave-optics model of a Gaussian surface ends in.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace gonio::reference {

/// W(g, b) = sum over m >= 1 of e^-g g^m/(m! m) e^(-b/m): Beckmann & Spizzichino 1963, 5.3. g, b >=
/// 0. Relative error below 1e-10 for g up to 2e8.
double wave_series(double g, double b);

/// g = (2 pi sigma/lambda cosines)^2, the variance of the phase; members and units as below.
template <class Surface>
double phase_variance(const Surface& surface, double sigma, double cosines)
{
    const double phase = 2 * std::numbers::pi * sigma / (surface.wavelength / 1000) * cosines;
    return phase * phase;
}

/// pi (tau/lambda)^2 W(g, b): what a surface with the members wavelength (nm), tau (um) and a
/// height deviation of sigma (um) scatters by diffraction, with b = (pi tau/lambda |l + v|_xy)^2.
/// Where g depends on incidence alone, this integrates to 1 - e^-g over the plane of direction
/// cosines.
template <class Surface>
double diffracted(const Surface& surface, double sigma, double cosines, glm::dvec3 l, glm::dvec3 v)
{
    using std::numbers::pi;
    const double lengths = surface.tau / (surface.wavelength / 1000);
    const double x = l.x + v.x, y = l.y + v.y;
    const double b = pi * pi * lengths * lengths * (x * x + y * y);
    return pi * lengths * lengths * wave_series(phase_variance(surface, sigma, cosines), b);
}

/// e^-g for the same g: what stays in the mirror direction.
template <class Surface>
double undiffracted(const Surface& surface, double sigma, double cosines)
{
    return std::exp(-phase_variance(surface, sigma, cosines));
}

}  // namespace gonio::reference

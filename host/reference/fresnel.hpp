// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance for unpolarised light by complex arithmetic, as optics books write it.
#pragma once

namespace gonio::reference {

/// Schlick, CGF 13(3), 1994, eq. 15.
double fresnel_schlick(double f0, double cos_theta);

/// Born & Wolf 14.2, eqs. 20 and 21 of 1.5.2 with the complex index eta + i k (relative to the
/// outside); k = 0 is a dielectric.
double fresnel_exact(double eta, double k, double cos_theta);

}  // namespace gonio::reference

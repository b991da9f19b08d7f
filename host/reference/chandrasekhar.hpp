// SPDX-License-Identifier: Apache-2.0
// The exact answer for a half-space that scatters isotropically and has the index of the medium
// above it.
#pragma once

namespace gonio::reference {

/// Chandrasekhar's H function for a cosine to the normal and a single-scattering albedo, both in
/// [0, 1]. To 1e-14.
double chandrasekhar_h(double cosine, double albedo);

/// The BRDF, 1/sr, which does not depend on azimuth. Not both cosines 0.
double chandrasekhar_brdf(double cosine_i, double cosine_o, double albedo);

/// The fraction of collimated light that comes back.
double chandrasekhar_plane_albedo(double cosine_i, double albedo);

/// The fraction of Lambertian light that comes back. To 1e-10.
double chandrasekhar_spherical_albedo(double albedo);

}  // namespace gonio::reference

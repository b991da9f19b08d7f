// SPDX-License-Identifier: Apache-2.0
// What light travels through: plane layers from top to bottom, and what lies above and below them.
#pragma once

#include <limits>
#include <variant>
#include <vector>

namespace gonio {

/// Henyey and Greenstein 1941. g is the mean cosine, in (-1, 1).
struct HenyeyGreenstein {
    double g = 0;
};

/// The same in every direction.
struct Isotropic {};

/// Rayleigh for unpolarised light: 3 (1 + cos^2) / (16 pi).
struct Rayleigh {};

/// weight_1 of Henyey-Greenstein with g_1, the rest of it with g_2.
struct TwoTermHenyeyGreenstein {
    double g_1 = 0;
    double g_2 = 0;
    double weight_1 = 1;
};

/// Linear in the cosine of the scattering angle between the given points, of any scale. The cosines
/// ascend from -1 (backward) to 1 (forward), the values are at least 0.
struct TabulatedPhase {
    std::vector<double> cosine;
    std::vector<double> value;
};

using PhaseFunction =
    std::variant<HenyeyGreenstein, Isotropic, Rayleigh, TwoTermHenyeyGreenstein, TabulatedPhase>;

/// A homogeneous layer. mus = 0 is a clear layer, such as glass.
struct Layer {
    double mua = 0;  ///< absorption coefficient, 1/cm
    double mus = 0;  ///< scattering coefficient, 1/cm
    double n = 1;    ///< refractive index
    /// Thickness, cm. Only the last layer may be infinite.
    double d = std::numeric_limits<double>::infinity();
    PhaseFunction phase = HenyeyGreenstein{};
};

/// What ends the last layer.
enum class Bottom {
    open,     ///< an interface to n_below
    black,    ///< absorbs all that arrives
    mirror,   ///< reflects all that arrives, as a mirror
    diffuse,  ///< reflects bottom_albedo of what arrives, Lambertian, and absorbs the rest
};

/// Layers from top to bottom between two clear half-spaces. Light comes from above.
struct LayeredMedium {
    double n_above = 1;
    double n_below = 1;
    std::vector<Layer> layers = {};
    Bottom bottom = Bottom::open;
    double bottom_albedo = 0;  ///< of the diffuse bottom, in [0, 1]
};

/// How light comes in: as a beam without width at r = 0, a beam of Gaussian or of even irradiance
/// around r = 0, or as Lambertian light.
enum class Beam { pencil, gaussian, top_hat, diffuse };

/// Light of unit flux that comes from above.
struct LightSource {
    Beam beam = Beam::pencil;
    double incidence = 0;  ///< of a beam, towards +x; rad from the normal, in [0, pi / 2)
    /// Across a beam, cm: where a Gaussian has fallen to 1/e^2, or the edge of an even one.
    double radius = 0;
};

/// Throws UsageError with the layer (counted from 1), the value and what is allowed, unless light
/// can travel through the medium: no layers, an index not above 0, a coefficient negative or not
/// finite, a phase function out of range, a thickness not above 0, an infinite layer that is not
/// last, or is clear and without absorption, or has a bottom other than open below it.
void validate(const LayeredMedium& medium);

}  // namespace gonio

// SPDX-License-Identifier: Apache-2.0
// Layered media that several tests share.
#pragma once

#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "gonio/layers.hpp"

namespace gonio::test {

constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

/// A Henyey-Greenstein layer, in the order in which papers print their tables.
inline Layer layer(double n, double mua, double mus, double g, double d)
{
    return {.mua = mua, .mus = mus, .n = n, .d = d, .phase = HenyeyGreenstein{g}};
}

inline LayeredMedium in_air(std::vector<Layer> layers)
{
    return {.layers = std::move(layers)};
}

/// van de Hulst, Multiple Light Scattering, 1980, table 35.
inline LayeredMedium van_de_hulst_slab(double n = 1)
{
    return in_air({layer(n, 10, 90, 0.75, 0.02)});
}

/// Giovanelli, Optica Acta 2, 1955.
inline LayeredMedium giovanelli_half_space()
{
    return in_air({layer(1.5, 10, 90, 0, infinite)});
}

/// The sample.mci of Wang and Jacques' MCML.
inline LayeredMedium mcml_sample()
{
    return in_air(
        {layer(1.37, 1, 100, 0.9, 0.1), layer(1.37, 1, 10, 0, 0.1), layer(1.37, 2, 10, 0.7, 0.2)});
}

/// Meglinski and Matcher, Med. Biol. Eng. Comput. 39, 2001, table 2 at 600 nm, as Alerstam et al.
/// 2010 use it.
inline LayeredMedium seven_layer_skin()
{
    return in_air({layer(1.53, 0.2, 1000, 0.9, 0.002), layer(1.34, 0.15, 400, 0.85, 0.008),
                   layer(1.4, 0.7, 300, 0.8, 0.01), layer(1.39, 1, 350, 0.9, 0.008),
                   layer(1.4, 0.7, 200, 0.76, 0.162), layer(1.39, 1, 350, 0.95, 0.02),
                   layer(1.44, 0.3, 150, 0.8, 0.59)});
}

/// Five-layer skin at 633 nm, Tuchin 1997, as shipped with GPU-MCML.
inline LayeredMedium five_layer_skin()
{
    return in_air({layer(1.5, 4.3, 107, 0.79, 0.01), layer(1.4, 2.7, 187, 0.82, 0.02),
                   layer(1.4, 3.3, 192, 0.82, 0.02), layer(1.4, 2.7, 187, 0.82, 0.09),
                   layer(1.4, 3.4, 194, 0.82, 0.06)});
}

/// Scattering over clear matter over a bottom.
inline LayeredMedium layers_over(Bottom bottom)
{
    LayeredMedium medium = in_air({layer(1.3, 1, 20, 0.7, 0.1), layer(1.5, 0.5, 0, 0, 0.1)});
    medium.bottom = bottom;
    medium.bottom_albedo = 0.6;
    medium.n_below = 1.4;
    return medium;
}

}  // namespace gonio::test

// SPDX-License-Identifier: Apache-2.0
// A photon of the scalar Monte Carlo.
#pragma once

#include <cmath>
#include <cstddef>

namespace gonio::reference {

struct ScalarPhoton {
    double x = 0, y = 0, z = 0;  ///< cm; z points down
    double ux = 0, uy = 0, uz = 1;
    double weight = 1;  ///< 0 where its life has ended
    std::size_t layer = 0;
    bool met_matter = false;  ///< has been where light is absorbed or scattered
    bool scattered = false;

    bool goes_down() const { return uz > 0; }
    double radius() const { return std::sqrt(x * x + y * y); }

    /// Wang, Jacques and Zheng 1995, eqs. 3.24 and 3.25.
    void turn(double cosine, double azimuth)
    {
        const double sine = std::sqrt((1 - cosine) * (1 + cosine));
        const double across = sine * std::cos(azimuth), aside = sine * std::sin(azimuth);
        const double before_x = ux, before_y = uy, before_z = uz;
        const double horizontal = std::sqrt(ux * ux + uy * uy);
        if (horizontal == 0) {
            ux = across;
            uy = aside;
        } else {
            ux = (before_x * before_z * across - before_y * aside) / horizontal + before_x * cosine;
            uy = (before_y * before_z * across + before_x * aside) / horizontal + before_y * cosine;
        }
        uz = before_z * cosine - horizontal * across;
    }
};

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Fresnel interfaces, and the geometric series of light between them.
#include "reference/adding_doubling/interface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio::reference {
namespace {

/// n cos of each direction, 0 where it does not exist.
Eigen::ArrayXd normal_components(const Directions& directions, double n)
{
    Eigen::ArrayXd normal(static_cast<Eigen::Index>(directions.all.size()));
    std::transform(directions.all.begin(), directions.all.end(), normal.begin(),
                   [&](const Direction& direction) {
                       return std::sqrt(std::max(direction.normal_squared(n), 0.0));
                   });
    return normal;
}

/// Unscattered fraction that a layer lets through in each direction.
Eigen::ArrayXd decay(const Layer& layer, const Directions& directions)
{
    const Eigen::ArrayXd normal = normal_components(directions, layer.n);
    const double extinction = layer.mua + layer.mus;
    return (normal > 0).select((-extinction * layer.d * layer.n / normal).exp(), 0.0);
}

}  // namespace

Interface fresnel_interface(const Directions& directions, double n_1, double n_2)
{
    const Eigen::ArrayXd k_1 = normal_components(directions, n_1);
    if (n_1 == n_2) return {(k_1 > 0).cast<double>() * 0, (k_1 > 0).cast<double>()};
    const Eigen::ArrayXd k_2 = normal_components(directions, n_2);
    // Born and Wolf, Principles of Optics, section 1.5.2, as transmittance so that nothing cancels.
    const double s = n_1 * n_1, p = n_2 * n_2;
    const Eigen::ArrayXd perpendicular = 4 * k_1 * k_2 / (k_1 + k_2).square();
    const Eigen::ArrayXd parallel = 4 * s * p * k_1 * k_2 / (p * k_1 + s * k_2).square();
    const Eigen::ArrayXd transmitted = (k_1 * k_2 > 0).select((perpendicular + parallel) / 2, 0.0);
    return {1 - transmitted, transmitted};
}

Interface bottom_interface(const LayeredMedium& medium, const Directions& directions)
{
    const Layer& last = medium.layers.back();
    const auto size = static_cast<Eigen::Index>(directions.all.size());
    Interface none{Eigen::ArrayXd::Zero(size), Eigen::ArrayXd::Zero(size)};
    if (std::isinf(last.d)) return none;
    switch (medium.bottom) {
        case Bottom::open:
            return fresnel_interface(directions, last.n, medium.n_below);
        case Bottom::mirror:
            return {Eigen::ArrayXd::Ones(size), none.transmitted};
        case Bottom::black:
        case Bottom::diffuse:
            break;
    }
    return none;
}

Interface follow_unscattered(const LayeredMedium& medium, const Directions& directions)
{
    Interface below = bottom_interface(medium, directions);
    for (std::size_t i = medium.layers.size(); i-- > 0;) {
        const Layer& layer = medium.layers[i];
        const double n_above = i > 0 ? medium.layers[i - 1].n : medium.n_above;
        const Interface top = fresnel_interface(directions, n_above, layer.n);
        const Eigen::ArrayXd once = decay(layer, directions);
        const Eigen::ArrayXd deeper = once.square() * below.reflected;
        const Eigen::ArrayXd entering =
            (top.transmitted > 0).select(top.transmitted / (1 - top.reflected * deeper), 0.0);
        below.reflected = top.reflected + top.transmitted * deeper * entering;
        below.transmitted *= once * entering;
    }
    return below;
}

Eigen::ArrayXd specular_reflectance(const LayeredMedium& medium, const Directions& directions)
{
    const Layer& first = medium.layers.front();
    if (first.mua + first.mus > 0)
        return fresnel_interface(directions, medium.n_above, first.n).reflected;
    LayeredMedium window = medium;
    window.layers.resize(1);
    if (medium.layers.size() > 1) {
        window.bottom = Bottom::open;
        window.n_below = medium.layers[1].n;
    }
    return follow_unscattered(window, directions).reflected;
}

}  // namespace gonio::reference

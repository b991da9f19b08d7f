// SPDX-License-Identifier: Apache-2.0
// Axes of the direction grids, and the unit vectors of their cells.
#include "gonio/grid.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gonio/errors.hpp"
#include "grid/angles.hpp"

namespace gonio {
namespace {

glm::dvec3 direction(double theta, double phi)
{
    const PolarAngle polar(theta);
    return {polar.sine * cosine_of_degrees(phi), polar.sine * sine_of_degrees(phi), polar.cosine};
}

/// Rusinkiewicz, EGWR 1998: d = (theta_d, phi_d) in the frame of h, turned by theta_h about y; o is
/// i mirrored at h.
std::pair<glm::dvec3, glm::dvec3> rusinkiewicz_vectors(double theta_h, double theta_d, double phi_d)
{
    const double sin_h = sine_of_degrees(theta_h), cos_h = cosine_of_degrees(theta_h);
    const double sin_d = sine_of_degrees(theta_d), cos_d = cosine_of_degrees(theta_d);
    const double x = sin_d * cosine_of_degrees(phi_d), y = sin_d * sine_of_degrees(phi_d);
    const auto above = [](double z) { return z > rusinkiewicz_horizon ? z : std::min(z, 0.0); };
    return {{sin_h * cos_d + cos_h * x, y, above(cos_h * cos_d - sin_h * x)},
            {sin_h * cos_d - cos_h * x, -y, above(cos_h * cos_d + sin_h * x)}};
}

}  // namespace

Axis make_axis(const std::string& name, double from, double to, std::size_t count, Samples samples)
{
    const bool nodes = samples == Samples::node;
    if (count < (nodes ? 2U : 1U))
        throw UsageError(fmt::format("axis `{}` has {} samples; allowed is at least {}", name,
                                     count, nodes ? "2 nodes, the two ends" : "1"));
    Axis axis{name, "deg", {}, samples};
    axis.values.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double position = nodes ? static_cast<double>(k) / static_cast<double>(count - 1)
                                      : (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        axis.values.push_back(from + (to - from) * position);
    }
    return axis;
}

Grid isotropic_grid(std::size_t theta_i, std::size_t theta_o, std::size_t delta_phi,
                    Samples samples, double delta_phi_to)
{
    return {GridKind::isotropic,
            {make_axis("theta_i", 0, 90, theta_i, samples),
             make_axis("theta_o", 0, 90, theta_o, samples),
             make_axis("delta_phi", 0, delta_phi_to, delta_phi, samples)}};
}

Grid anisotropic_grid(std::size_t theta_i, std::size_t phi_i, std::size_t theta_o,
                      std::size_t phi_o, Samples samples)
{
    return {
        GridKind::anisotropic,
        {make_axis("theta_i", 0, 90, theta_i, samples), make_axis("phi_i", 0, 360, phi_i, samples),
         make_axis("theta_o", 0, 90, theta_o, samples),
         make_axis("phi_o", 0, 360, phi_o, samples)}};
}

Grid rusinkiewicz_grid(std::size_t theta_h, std::size_t theta_d, std::size_t phi_d, Samples samples,
                       Spacing spacing)
{
    Grid grid{GridKind::rusinkiewicz,
              {make_axis("theta_h", 0, 90, theta_h, samples),
               make_axis("theta_d", 0, 90, theta_d, samples),
               make_axis("phi_d", 0, 180, phi_d, samples)}};
    if (spacing == Spacing::merl)
        for (double& theta : grid.axes[0].values) theta = theta * theta / 90;
    return grid;
}

std::pair<glm::dvec3, glm::dvec3> unit_vectors(const DirectionPair& pair)
{
    return {direction(pair.theta_i, pair.phi_i), direction(pair.theta_o, pair.phi_o)};
}

std::pair<glm::dvec3, glm::dvec3> unit_vectors(const Grid& grid, std::size_t row,
                                               std::size_t column)
{
    const auto& axes = grid.axes;
    if (grid.kind == GridKind::anisotropic) {
        const std::size_t outgoing = row % axes[2].values.size(),
                          incoming = row / axes[2].values.size();
        return unit_vectors({axes[0].values[incoming / axes[1].values.size()],
                             axes[1].values[incoming % axes[1].values.size()],
                             axes[2].values[outgoing], axes[3].values[column]});
    }
    const double outer = axes[0].values[row / axes[1].values.size()];
    const double inner = axes[1].values[row % axes[1].values.size()];
    if (grid.kind == GridKind::rusinkiewicz)
        return rusinkiewicz_vectors(outer, inner, axes[2].values[column]);
    return unit_vectors({outer, 0, inner, axes[2].values[column]});
}

}  // namespace gonio

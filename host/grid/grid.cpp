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

GridVectors::GridVectors(const Grid& grid) : kind_(grid.kind)
{
    for (const Axis& axis : grid.axes) {
        std::vector<SineCosine>& values = axes_.emplace_back();
        const bool from_normal = axis.name == "theta_i" || axis.name == "theta_o";
        for (const double degrees : axis.values) {
            const PolarAngle polar(from_normal ? degrees : 0);
            values.push_back(
                from_normal ? SineCosine{polar.sine, polar.cosine}
                            : SineCosine{sine_of_degrees(degrees), cosine_of_degrees(degrees)});
        }
    }
}

std::pair<glm::dvec3, glm::dvec3> GridVectors::at(std::size_t row, std::size_t column) const
{
    const auto direction = [](SineCosine theta, SineCosine phi) {
        return glm::dvec3(theta.sine * phi.cosine, theta.sine * phi.sine, theta.cosine);
    };
    const SineCosine phi = axes_.back()[column];
    if (kind_ == GridKind::anisotropic) {
        const std::size_t outgoing = row % axes_[2].size(), incoming = row / axes_[2].size();
        return {
            direction(axes_[0][incoming / axes_[1].size()], axes_[1][incoming % axes_[1].size()]),
            direction(axes_[2][outgoing], phi)};
    }
    const SineCosine outer = axes_[0][row / axes_[1].size()],
                     inner = axes_[1][row % axes_[1].size()];
    if (kind_ == GridKind::isotropic) return {direction(outer, {0, 1}), direction(inner, phi)};
    // Rusinkiewicz, EGWR 1998: d = (theta_d, phi_d) in the frame of h, turned by theta_h about y; o
    // is i mirrored at h.
    const double x = inner.sine * phi.cosine, y = inner.sine * phi.sine;
    const double along = outer.sine * inner.cosine, up = outer.cosine * inner.cosine;
    const auto above = [](double z) { return z > rusinkiewicz_horizon ? z : std::min(z, 0.0); };
    return {{along + outer.cosine * x, y, above(up - outer.sine * x)},
            {along - outer.cosine * x, -y, above(up + outer.sine * x)}};
}

}  // namespace gonio

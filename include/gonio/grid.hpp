// SPDX-License-Identifier: Apache-2.0
// Grids of direction pairs, and lists of them.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "gonio/table.hpp"

namespace gonio {

/// isotropic: (theta_i, theta_o, delta_phi); anisotropic: (theta_i, phi_i, theta_o, phi_o);
/// rusinkiewicz: (theta_h, theta_d, phi_d) with the half vector at azimuth 0 (Rusinkiewicz, EGWR
/// 1998).
enum class GridKind { isotropic, anisotropic, rusinkiewicz };

/// How samples lie on theta_h: evenly, or as in MERL's files, dense at the highlight: theta_h = 90
/// deg (k / n)^2.
enum class Spacing { linear, merl };

/// Axes in degrees, from the outermost to the innermost. Angles from the normal are 0 to 90;
/// azimuths 0 to 360.
struct Grid {
    GridKind kind = GridKind::isotropic;
    std::vector<Axis> axes;
};

/// Evenly spaced samples over [from, to]: in the middles of `count` cells, or on `count` nodes with
/// both ends. Throws UsageError for no samples, and for a single node.
Axis make_axis(const std::string& name, double from, double to, std::size_t count, Samples samples);

/// counts: one per axis. delta_phi_to: 180 (all there is for an isotropic material) or 360.
Grid isotropic_grid(std::size_t theta_i, std::size_t theta_o, std::size_t delta_phi,
                    Samples samples, double delta_phi_to = 360);
Grid anisotropic_grid(std::size_t theta_i, std::size_t phi_i, std::size_t theta_o,
                      std::size_t phi_o, Samples samples);
Grid rusinkiewicz_grid(std::size_t theta_h, std::size_t theta_d, std::size_t phi_d, Samples samples,
                       Spacing spacing = Spacing::linear);

/// A pair of directions in degrees.
struct DirectionPair {
    double theta_i = 0, phi_i = 0, theta_o = 0, phi_o = 0;
};

/// Unit vectors to light and viewer, n = +z. At exactly 90 degrees the direction lies 1e-11 above
/// the horizon, so that a model's limit there can be told from its pole.
std::pair<glm::dvec3, glm::dvec3> unit_vectors(const DirectionPair& pair);

/// Directions of a Rusinkiewicz grid with a cosine up to here count as below the horizon: f is 0
/// there.
inline constexpr double rusinkiewicz_horizon = 1e-7;

/// The unit vectors of a grid's cells; the trigonometry of its axes is done once.
class GridVectors {
public:
    explicit GridVectors(const Grid& grid);

    /// To light and viewer. Below the horizon of a Rusinkiewicz grid z is 0 or less.
    std::pair<glm::dvec3, glm::dvec3> at(std::size_t row, std::size_t column) const;

private:
    struct SineCosine {
        double sine, cosine;
    };

    GridKind kind_;
    std::vector<std::vector<SineCosine>> axes_;  ///< as the grid's
};

}  // namespace gonio

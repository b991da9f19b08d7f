// SPDX-License-Identifier: Apache-2.0
// The directions of adding-doubling: quadrature nodes that Snell's law matches between all media of
// a stack, and directions of measure zero that are wanted exactly.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "gonio/layers.hpp"

namespace gonio::reference {

/// A direction, told by its cosine to the normal in a medium of index n. Snell's law makes it one
/// direction of every other medium too. Light crosses interfaces at a constant q = (n sin)^2, which
/// is what integrals run over.
struct Direction {
    double n = 1;
    double cosine = 1;

    /// (m cos)^2 in a medium of index m, without cancellation; not above 0 where total reflection
    /// keeps it out.
    double normal_squared(double m) const { return (m - n) * (m + n) + n * cosine * n * cosine; }

    bool operator==(const Direction&) const = default;
};

using Places = std::vector<Eigen::Index>;

/// Directions that are wanted exactly, each once.
class ExactDirections {
public:
    /// Adds those at angles to the normal, rad, in a medium of index n and returns where they are.
    /// Throws UsageError unless the angles are in [0, pi / 2).
    Places add(double n, const std::vector<double>& angles);
    const std::vector<Direction>& all() const { return all_; }

private:
    std::vector<Direction> all_;
};

/// All directions of a problem, those of the quadrature first.
struct Directions {
    std::vector<Direction> all;
    Eigen::Index quadrature = 0;
    Eigen::VectorXd root_weight;  ///< square root of the weight in q; 1 for the exact directions

    Eigen::Index size() const { return root_weight.size(); }
    /// From places among the exact directions to places among all.
    Places of_exact(Places places) const;
};

/// About `nodes` quadrature directions for the media of a stack, and then the `exact` ones. The
/// range of q is split at every index squared, where some medium has its critical angle; in each
/// part the nodes are those of Gauss-Legendre in the cosine of the medium that is at grazing there,
/// in which radiance has no square root.
Directions choose_directions(const LayeredMedium& medium, int nodes, const ExactDirections& exact);

/// How many nodes a solution has whose difference to one with `nodes` tells the error.
int coarser(int nodes);

/// An error over that difference. One that falls as 1 / nodes^2, the worst that occurs, equals the
/// difference; twice that allows for differences that are small by chance.
constexpr double error_over_difference = 2;

/// The directions that exist in one medium.
struct LocalDirections {
    LocalDirections(const Directions& directions, double index);

    double n;
    std::vector<Eigen::Index> ids;  ///< places in Directions::all, ascending
    Eigen::Index quadrature;        ///< how many of them belong to the quadrature
    Eigen::ArrayXd cosine;
    Eigen::VectorXd root_weight;

    Eigen::Index size() const { return cosine.size(); }
};

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Chooses quadrature directions for a stack of media with different refractive indices.
#include "reference/adding_doubling/directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>

#include "gonio/errors.hpp"
#include "reference/gauss_legendre.hpp"

namespace gonio::reference {
namespace {

/// Part of the range of q between the squares of two neighbouring indices.
struct Part {
    double n_low;
    double n_high;
    double share;  ///< of the nodes, before normalisation
};

/// Nodes go to a part by the largest angle that it takes in any medium. The exponent gives narrow
/// parts more than their share: on stacks of tissue it saves a third of the nodes for the same
/// error.
std::vector<Part> split(const std::set<double>& indices)
{
    constexpr double exponent = 0.75;
    std::vector<Part> parts;
    double n_low = 0;
    for (auto high = indices.begin(); high != indices.end(); n_low = *high++) {
        double angle = 0;
        for (auto n = high; n != indices.end(); ++n) {
            angle = std::max(angle, std::asin(*high / *n) - std::asin(n_low / *n));
        }
        parts.push_back({n_low, *high, std::pow(angle, exponent)});
    }
    return parts;
}

}  // namespace

Places ExactDirections::add(double n, const std::vector<double>& angles)
{
    Places places;
    for (const double angle : angles) {
        if (!(angle >= 0 && angle < std::numbers::pi / 2)) {
            throw UsageError(fmt::format("an angle to the normal of {} degrees must be in [0, 90)",
                                         angle * 180 / std::numbers::pi));
        }
        const Direction direction{n, std::cos(angle)};
        const auto found = std::find(all_.begin(), all_.end(), direction);
        places.push_back(found - all_.begin());
        if (found == all_.end()) all_.push_back(direction);
    }
    return places;
}

Places Directions::of_exact(Places places) const
{
    for (Eigen::Index& place : places) place += quadrature;
    return places;
}

int coarser(int nodes)
{
    return static_cast<int>(std::lround(nodes / std::numbers::sqrt2));
}

Directions choose_directions(const LayeredMedium& medium, int nodes, const ExactDirections& exact)
{
    const int least_in_a_part =
        std::max(1, nodes / 12);  // so that fewer nodes are fewer in every part
    std::set<double> indices = {medium.n_above};
    for (const Layer& layer : medium.layers) indices.insert(layer.n);
    if (medium.bottom == Bottom::open && std::isfinite(medium.layers.back().d)) {
        indices.insert(medium.n_below);
    }
    const std::vector<Part> parts = split(indices);
    double shares = 0;
    for (const Part& part : parts) shares += part.share;

    Directions directions;
    std::vector<double> root_weight;
    for (const Part& part : parts) {
        const auto share = static_cast<int>(std::lround(nodes * part.share / shares));
        const QuadratureRule rule = gauss_legendre(std::max(share, least_in_a_part));
        const double n = part.n_high;
        const double range = std::sqrt((n - part.n_low) * (n + part.n_low)) / n;
        for (Eigen::Index i = rule.nodes.size(); i-- > 0;) {
            const double cosine = range * rule.nodes(i);
            directions.all.push_back({n, cosine});
            root_weight.push_back(
                std::sqrt(2 * n * n * cosine * range * rule.weights(i)));  // dq = 2 n^2 mu dmu
        }
    }
    directions.quadrature = static_cast<Eigen::Index>(directions.all.size());
    directions.all.insert(directions.all.end(), exact.all().begin(), exact.all().end());
    root_weight.resize(directions.all.size(), 1.0);
    directions.root_weight = Eigen::Map<const Eigen::VectorXd>(
        root_weight.data(), static_cast<Eigen::Index>(root_weight.size()));
    return directions;
}

LocalDirections::LocalDirections(const Directions& directions, double index)
    : n(index), quadrature(0)
{
    std::vector<double> cosines;
    for (std::size_t i = 0; i < directions.all.size(); ++i) {
        const double normal_squared = directions.all[i].normal_squared(n);
        if (normal_squared <= 0) continue;
        const auto id = static_cast<Eigen::Index>(i);
        ids.push_back(id);
        cosines.push_back(std::sqrt(normal_squared) / n);
        if (id < directions.quadrature) ++quadrature;
    }
    cosine =
        Eigen::Map<const Eigen::ArrayXd>(cosines.data(), static_cast<Eigen::Index>(cosines.size()));
    root_weight = directions.root_weight(ids);
}

}  // namespace gonio::reference

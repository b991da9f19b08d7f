// SPDX-License-Identifier: Apache-2.0
// Adding (van de Hulst 1963; Grant and Hunt 1969) with interfaces between the layers.
#include "reference/adding_doubling/stack.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/adding_doubling/interface.hpp"

namespace gonio::reference {
namespace {

/// From the directions of one medium to those of the problem; the others carry nothing there.
LightOperator embed(const LightOperator& local, const LocalDirections& from, const Directions& to)
{
    const auto size = static_cast<Eigen::Index>(to.all.size());
    LightOperator all = specular(Eigen::VectorXd::Zero(size), to.quadrature);
    all.diagonal(from.ids) = local.diagonal;
    all.kernel(from.ids, from.ids) = local.kernel;
    return all;
}

/// What lies under the last layer, seen from inside that layer.
LightOperator bottom(const LayeredMedium& medium, const Directions& directions, int mode)
{
    LightOperator reflection =
        specular(bottom_interface(medium, directions).reflected, directions.quadrature);
    if (medium.bottom == Bottom::diffuse && mode == 0) {
        const double n = medium.layers.back().n;
        const LocalDirections local(directions, n);
        reflection.kernel(local.ids, local.ids) =
            medium.bottom_albedo / (n * n) * local.root_weight * local.root_weight.transpose();
    }
    return reflection;
}

/// A layer with everything below it.
struct Level {
    LightOperator enter;   ///< light above its upper interface to downward light below it
    LightOperator cross;   ///< downward light at its top to downward light at its bottom
    LightOperator top;     ///< reflection seen at its top, inside
    LightOperator bottom;  ///< reflection seen at its bottom, inside
};

}  // namespace

Stack add_layers(const LayeredMedium& medium, const Directions& directions, int mode,
                 const SlabSolver& solver)
{
    const std::size_t count = medium.layers.size();
    std::vector<Level> levels(count);
    LightOperator reflection = bottom(medium, directions, mode);
    for (std::size_t i = count; i-- > 0;) {
        const Layer& layer = medium.layers[i];
        const LocalDirections local(directions, layer.n);
        const Slab slab = solver(layer, local, mode);
        const LightOperator r = embed(slab.reflection, local, directions);
        const LightOperator t = embed(slab.transmission, local, directions);
        Level& level = levels[i];
        level.bottom = reflection;
        level.cross = after_round_trips(r * level.bottom, t);
        level.top = r + t * (level.bottom * level.cross);

        const double n_above = i > 0 ? medium.layers[i - 1].n : medium.n_above;
        const auto [reflected, transmitted] = fresnel_interface(directions, n_above, layer.n);
        level.enter = after_round_trips(reflected * level.top, specular(transmitted, r.quadrature));
        reflection = specular(reflected, r.quadrature) + transmitted * (level.top * level.enter);
    }

    LightOperator arriving = levels[0].enter;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) arriving = levels[i].enter * arriving;
        arriving = levels[i].cross * arriving;
    }

    // Net downward flux at the top of each layer and at the bottom.
    const Eigen::VectorXd& flux = directions.root_weight;
    Eigen::MatrixXd net(count + 1, flux.size());
    for (std::size_t i = 0; i <= count; ++i) {
        const LightOperator& back = i < count ? levels[i].top : levels[i - 1].bottom;
        Eigen::VectorXd gain = flux - worth_before(flux, back);
        for (std::size_t k = std::min(i + 1, count); k-- > 0;) {
            if (k < i) gain = worth_before(gain, levels[k].cross);
            gain = worth_before(gain, levels[k].enter);
        }
        net.row(static_cast<Eigen::Index>(i)) = gain.cwiseQuotient(flux).transpose();
    }
    Eigen::MatrixXd kept = net;
    kept.topRows(net.rows() - 1) -= net.bottomRows(net.rows() - 1);
    return {reflection, bottom_interface(medium, directions).transmitted * arriving, kept};
}

}  // namespace gonio::reference

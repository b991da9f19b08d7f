// SPDX-License-Identifier: Apache-2.0
// Gauss-Legendre quadrature of any order.
#pragma once

#include <Eigen/Core>

namespace gonio::reference {

/// Nodes, ascending, and weights of a rule on [0, 1].
struct QuadratureRule {
    Eigen::VectorXd nodes;
    Eigen::VectorXd weights;
};

/// The rule with `count` >= 1 nodes, exact for polynomials of degree 2 count - 1.
QuadratureRule gauss_legendre(int count);

}  // namespace gonio::reference

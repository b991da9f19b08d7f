// SPDX-License-Identifier: Apache-2.0
// Reflection and transmission as linear operators on light in the directions of one medium.
#pragma once

#include <Eigen/Core>

namespace gonio::reference {

/// Takes the flux of each direction to fluxes of the same directions. `diagonal` keeps light in its
/// direction (mirror reflection, unscattered transmission: a Dirac delta). `kernel` spreads it:
/// kernel(i, j) is the flux per q of i for unit flux in j, times the root weights of i and j, which
/// makes it symmetric where physics is reciprocal. The first `quadrature` directions carry
/// integrals; the others have no measure, are fed by all and feed none.
struct LightOperator {
    Eigen::VectorXd diagonal;
    Eigen::MatrixXd kernel;
    Eigen::Index quadrature = 0;
};

/// Only a diagonal.
LightOperator specular(Eigen::VectorXd diagonal, Eigen::Index quadrature);

LightOperator operator+(const LightOperator& a, const LightOperator& b);

/// First a, then a mirror or a window that keeps light in its direction.
LightOperator operator*(const Eigen::ArrayXd& mirror, const LightOperator& a);

/// First b, then a.
LightOperator operator*(const LightOperator& a, const LightOperator& b);

/// The same where the product is symmetric, as reciprocity makes a slab's: half of the work.
LightOperator symmetric_product(const LightOperator& a, const LightOperator& b);

/// b + a b + a a b + ... = (1 - a)^-1 b: light that goes round between two reflectors.
LightOperator after_round_trips(const LightOperator& a, const LightOperator& b);

/// Row vector times operator: from what light is worth after `a` in each direction to what it is
/// worth before. The worth of flux is the root weights.
Eigen::VectorXd worth_before(const Eigen::VectorXd& worth, const LightOperator& a);

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Adding: layers and interfaces from the bottom up.
#pragma once

#include <Eigen/Core>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/directions.hpp"
#include "reference/adding_doubling/light_operator.hpp"
#include "reference/adding_doubling/slab.hpp"

namespace gonio::reference {

/// What a stack does to light that comes from above in each of the problem's directions.
struct Stack {
    LightOperator reflection;
    LightOperator transmission;  ///< through an open bottom
    /// Row l, column j: the fraction of the flux in direction j that layer l absorbs; the last row
    /// is what passes the bottom.
    Eigen::MatrixXd kept;
};

/// Adds up the layers for the part of the light that goes as cos(mode phi); `kept` is meant for
/// mode 0.
Stack add_layers(const LayeredMedium& medium, const Directions& directions, int mode,
                 const SlabSolver& solver);

}  // namespace gonio::reference

// SPDX-License-Identifier: Apache-2.0
// Reflection and transmission of one homogeneous layer without its interfaces.
#pragma once

#include <functional>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/directions.hpp"
#include "reference/adding_doubling/light_operator.hpp"

namespace gonio::reference {

/// The same from above and from below.
struct Slab {
    LightOperator reflection;
    LightOperator transmission;
};

/// Solves the radiative transfer equation in a layer by doubling, for the part of the light that
/// goes as cos(mode phi) with the azimuth. mode = 0 is the azimuthal mean and conserves energy to
/// the last digits. An infinite layer transmits nothing.
Slab solve_slab(const Layer& layer, const LocalDirections& directions, int mode);

/// The same; what `after_doubling` throws ends the work.
Slab solve_slab_by_steps(const Layer& layer, const LocalDirections& directions, int mode,
                         const std::function<void()>& after_doubling);

/// solve_slab, or what gives the same slabs.
using SlabSolver =
    std::function<Slab(const Layer& layer, const LocalDirections& directions, int mode)>;

}  // namespace gonio::reference

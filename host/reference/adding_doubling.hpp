// SPDX-License-Identifier: Apache-2.0
// The noise-free answer for layered media: adding-doubling in double precision for any number of
// layers, each with its own refractive index.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/refinement.hpp"
#include "reference/adding_doubling/slab.hpp"

namespace gonio::reference {

/// Where the light of unit flux ends. All of it adds up to 1.
struct LightBudget {
    /// Reflected before it meets anything that absorbs or scatters (MCML's Rsp).
    double specular = 0;
    double diffuse_reflectance = 0;        ///< all else that leaves upwards (MCML's Rd)
    double unscattered_transmittance = 0;  ///< leaves through an open bottom, never scattered
    double diffuse_transmittance = 0;      ///< all else that leaves through an open bottom
    std::vector<double> absorption;        ///< in each layer
    double bottom_absorption = 0;          ///< by a black or diffuse bottom
};

/// One illumination of unit flux, and what becomes of it.
struct Illumination {
    LightBudget budget;
    // Radiant intensity, 1/sr (MCML's Rd(alpha), Tt(alpha)), without what is specular.
    Eigen::VectorXd reflected;    ///< at each of exit_above
    Eigen::VectorXd transmitted;  ///< at each of exit_below
    // What of a beam keeps to one angle and is no intensity: never scattered, or by less than the
    // quadrature tells apart. Upwards again without what is specular.
    double narrow_reflected = 0;
    double narrow_transmitted = 0;
};

/// What is asked of a medium. Angles to the normal, rad, in [0, pi / 2).
struct LightRequest {
    std::vector<double> incidence = {};   ///< of collimated light in the medium above
    std::vector<double> exit_above = {};  ///< in the medium above
    std::vector<double> exit_below = {};  ///< in the medium below
};

struct LayeredSolution {
    std::vector<Illumination> collimated;  ///< for each incidence
    Illumination diffuse;                  ///< Lambertian light from above
    int nodes = 0;                         ///< quadrature directions asked for
    // Bounds come from the difference to a solution with 0.7 times the nodes.
    double error = 0;          ///< of the worst number in the budgets
    double angular_error = 0;  ///< of the worst intensity, over the largest of its illumination

    /// Under such a light, of whose beams the first incidence is that one's.
    const Illumination& under(const LightSource& light) const
    {
        return light.beam == Beam::diffuse ? diffuse : collimated.front();
    }
};

/// Solves with about `nodes` quadrature directions a hemisphere: for tissue 48 give 1e-6 and 96
/// give 1e-8. The intensities at single angles converge later than the budgets where a phase
/// function has a sharp peak. Throws UsageError as validate() does, and for angles out of range.
LayeredSolution solve_layers(const LayeredMedium& medium, const LightRequest& request, int nodes);

/// The same at two thirds of the price, with errors of 0 that mean nothing.
LayeredSolution solve_layers_once(const LayeredMedium& medium, const LightRequest& request,
                                  int nodes, const SlabSolver& solver = solve_slab);

/// Raises the number of nodes until no error is above `tolerance`, or goes_on says no. Throws
/// RunError where 512 are not enough, unless the tolerance is 0: as close as they come.
LayeredSolution solve_layers_to(
    const LayeredMedium& medium, const LightRequest& request, double tolerance,
    const AfterPart& after_part = [](double) {}, const GoesOn& goes_on = goes_on_always);

}  // namespace gonio::reference

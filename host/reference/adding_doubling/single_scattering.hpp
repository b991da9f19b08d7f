// SPDX-License-Identifier: Apache-2.0
// What truncation takes from light that is scattered once.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gonio/layers.hpp"
#include "reference/adding_doubling/directions.hpp"

namespace gonio::reference {

/// The BRDF of light scattered once with the phase functions of the layers less that with their
/// truncated ones, both behind the truncated ones' extinction. Angles in rad; azimuths are 0 on the
/// side of the mirror direction. Nakajima and Tanaka, J. Quant. Spectrosc. Radiat. Transfer 40,
/// 1988 (TMS), for layers with boundaries that light crosses straight in and straight out. To add
/// it makes the BRDF converge where a phase function has a peak.
class SingleScattering {
public:
    SingleScattering(const LayeredMedium& medium, const Directions& directions,
                     const std::vector<double>& delta_phi);

    /// At each of the azimuths.
    Eigen::ArrayXd operator()(double theta_i, double theta_o) const;

private:
    struct Scatterer {
        const Layer* layer;
        double extinction;        ///< truncated, 1/cm
        double smooth;            ///< coefficient of the truncated phase function, 1/cm
        Eigen::VectorXd moments;  ///< of it
    };
    static Eigen::ArrayXd difference(const Scatterer& layer, const Eigen::ArrayXd& cosines);

    double n_above_;
    std::vector<Scatterer> layers_;
    Eigen::ArrayXd cosines_;  ///< of the azimuths
};

}  // namespace gonio::reference
